# A bounded run of the fuzzer on the packer's readers, from real files as seeds. What it finds differs from run to
# run: a finding is printed, to be kept as a test.
#   fuzz.sh BUILD [SECONDS]
. "$(dirname "$0")/common.sh"
needs_built tests/fuzz_pack # by clang
seconds=${2:-30}
mkdir -p "$WORK/seeds"
seed() { { printf "\\x0$1"; cat "$2"; } >"$WORK/seeds/$3"; } # seed READER FILE NAME
bash "$SOURCE/packer/example/build.sh" "$BUILD/pack" "$WORK" >/dev/null || exit 1
seed 0 "$WORK/hello.elf" elf
seed 1 "$WORK/hello" packed
tail -c +$((528 + $(stat -c %s "$BUILD/generated/stub.bin") + 1)) "$WORK/hello" >"$WORK/parameters"
seed 2 "$WORK/parameters" parameters
{ printf '\xfe'; cat "$WORK/parameters"; } >"$WORK/seeds/decoded"
"$BUILD/pack" "$WORK/hello.elf" -o "$WORK/again" --save-model "$WORK/model" >/dev/null || exit 1
seed 3 "$WORK/model" model
cd "$WORK" || exit 1
check "seeds for each reader" test "$(find seeds -size +0 | wc -l)" -ge 6
fuzz() {
    # -timeout: what hangs, not what waits for a busy machine
    if "$BUILD/tests/fuzz_pack" -max_total_time="$seconds" -timeout=200 -rss_limit_mb=3000 -max_len=8192 -verbosity=0 -print_final_stats=1 seeds >"$WORK/log" 2>&1; then
        grep -E 'executed_units|new_units' "$WORK/log"
    else
        tail -n 40 "$WORK/log"
        for finding in crash-* timeout-* oom-*; do
            [ -e "$finding" ] && echo "$finding, by base64 -d:" && base64 -w 0 "$finding" && echo
        done
        return 1
    fi
}
check "the readers survive $seconds s of the fuzzer" fuzz
check "... which tried some" test "$(sed -n 's/^stat::number_of_executed_units: //p' "$WORK/log")" -gt 100
finish

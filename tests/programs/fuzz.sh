# A bounded run of the fuzzer on the packer's readers, from real files as seeds. What it finds differs from run to
# run: a finding is printed, to be kept as a test. To search further: SECONDS_TO_FUZZ=600 bash tests/programs/fuzz.sh build
. "$(dirname "$0")/common.sh"
[ -x "$BUILD/tests/fuzz_pack" ] || { echo "SKIPPED: fuzz_pack is not built: clang is not installed"; exit 77; }
mkdir -p "$WORK/seeds"
seed() { { printf "\\x0$1"; cat "$2"; } >"$WORK/seeds/$3"; } # seed READER FILE NAME
bash "$SOURCE/packer/example/build.sh" "$BUILD/pack" "$WORK" >/dev/null
seed 0 "$WORK/hello.elf" elf
seed 1 "$WORK/hello" packed
tail -c +$((528 + $(stat -c %s "$BUILD/generated/stub.bin") + 1)) "$WORK/hello" >"$WORK/parameters"
seed 2 "$WORK/parameters" parameters
{ printf '\xfe'; cat "$WORK/parameters"; } >"$WORK/seeds/decoded"
"$BUILD/pack" "$WORK/hello.elf" -o "$WORK/again" --save-model "$WORK/model" >/dev/null
seed 3 "$WORK/model" model
cd "$WORK" || exit 1
fuzz() {
    if "$BUILD/tests/fuzz_pack" -max_total_time="$SECONDS_TO_FUZZ" -timeout=20 -rss_limit_mb=3000 -max_len=8192 -verbosity=0 -print_final_stats=1 seeds >"$WORK/log" 2>&1; then
        grep -E 'executed_units|new_units' "$WORK/log"
    else
        tail -n 40 "$WORK/log"
        for finding in crash-* timeout-* oom-*; do
            [ -e "$finding" ] && echo "$finding, by base64 -d:" && base64 -w 0 "$finding" && echo
        done
        return 1
    fi
}
check "the readers survive ${SECONDS_TO_FUZZ:=30} s of the fuzzer" fuzz
finish

# The packed film, cut short and with wrong bytes, reports that it is damaged, or the system refuses it. It never runs,
# never hangs, and leaves no files.
#   damaged.sh BUILD [TRIES] [SEED]
# The film cannot check its first 656 bytes: the header, which the system and its loader read, and the code of the check
# itself (packer/README.md). A changed byte there could make the program do anything, so these bytes are not changed;
# the file is only cut there. tests/programs/packed.sh damages a small program everywhere.
. "$(dirname "$0")/../common.sh"
tries=${2:-100} seed=${3:-$((EPOCHSECONDS % 30000))}
needs_built odraz
unset DISPLAY WAYLAND_DISPLAY
echo "    seed $seed"
RANDOM=$seed
UNGUARDED=656
film=$BUILD/odraz size=$(stat -c %s "$BUILD/odraz")
mkdir "$WORK/in"
cd "$WORK/in" || exit 1
broken=$WORK/broken
check "the film, whole, runs" prints '^odraz' "$film" --version

from() { local span=$(($2 - $1)); at=$(($1 + (RANDOM * 32768 + RANDOM) % span)); } # from A B: sets `at` to a random offset, A <= at < B
write() { dd of="$broken" bs=1 seek="$1" conv=notrunc status=none; }             # write OFFSET: copies standard input to it
reports_it() { refuses 1 "damaged: copy it again" "$broken" --dump - --from 20 --to 20.04 --size 16x9; }
each() { # each COMMAND: the command damages $broken, $tries times; the film must report it each time
    local n
    for ((n = 1; n <= tries; ++n)); do
        cp "$film" "$broken"
        "$@"
        cmp -s "$film" "$broken" && continue
        reports_it || { echo "try $n of seed $seed: $*, at $at of $size" >&2; return 1; }
    done
}
wrong_bytes() { # overwrites up to 4096 bytes with other bytes of the file
    local to
    from $UNGUARDED "$size"
    to=$at
    from 0 "$size"
    tail -c +$((at + 1)) "$film" | head -c $((RANDOM % 4096 + 1)) | head -c $((size - to)) | write $to
}
cut_anywhere() {
    from 660 "$size"
    truncate -s $at "$broken"
}
filled_up() { # replaces the file's end with zeros
    from 660 $((size - 100))
    truncate -s $at "$broken"
    truncate -s "$size" "$broken"
}
check "wrong bytes, $tries times" each wrong_bytes
check "cut short" each cut_anywhere
check "cut short, and zeros in place of the rest" each filled_up

# Cut at the borders of the header, the check, the stub and pages, and in the last bytes
refused_somehow() {
    local status
    truncate -s 0 "$broken"
    head -c "$1" "$film" >"$broken"
    timeout "$PATIENCE" bash -c "exec '$broken' --dump - --from 20 --to 20.04 --size 16x9" >"$WORK/out" 2>"$WORK/err" </dev/null
    status=$?
    [ $status != 0 ] && [ $status != 124 ] && [ ! -s "$WORK/out" ] && return
    echo "of $1 bytes: exit status $status" >&2
    return 1
}
borders() {
    local length
    for length in 1 4 63 64 65 120 400 527 528 529 600 655 656 657 658 659; do refused_somehow $length || return 1; done
    for length in 660 661 700 2666 4095 4096 4097 8192 32768 $((size / 4096 * 4096)) $((size - 5)) $((size - 4)) $((size - 3)) $((size - 2)) $((size - 1)); do
        head -c "$length" "$film" >"$broken"
        reports_it || { echo "of $length bytes" >&2; return 1; }
    done
}
check "cut at borders" borders
check "nothing is written" test -z "$(ls -A)"
finish

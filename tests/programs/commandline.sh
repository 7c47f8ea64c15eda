# Options, and outputs that fail: one line that helps, the right status, nothing half-written.
. "$(dirname "$0")/common.sh"
unset DISPLAY
for odraz in "$BUILD/odraz" "$BUILD/odraz-safe"; do
    name=${odraz##*/}
    check "$name --version" bash -c "'$odraz' --version | grep -qE '^odraz [0-9]+\.[0-9]+\.[0-9]+ [0-9a-f]{12}\+?$|unknown'"
    check "$name --help names every option" bash -c "for o in window stats dump fps from to size quality threads version; do '$odraz' --help | grep -q -- --\$o || exit 1; done"
    check "$name refuses an unknown option" refuses 2 "unknown option '--nope'" "$odraz" --nope
    check "$name refuses a bad value" refuses 2 "--fps needs" "$odraz" --dump - --fps abc
    check "$name refuses a missing value" refuses 2 "--size needs" "$odraz" --size
    check "$name refuses a time beyond the film" refuses 2 "beyond the film's end" "$odraz" --to 999
    check "$name --help on a full disk" refuses 1 "no space left" bash -c "'$odraz' --help >/dev/full"
    check "$name --version on a closed stdout" refuses 1 "closed" bash -c "'$odraz' --version >&-"

    small=(--size 64x36 --from 20 --to 20.2 --quality draft)
    check "$name dumps to a full disk" refuses 1 "cannot write standard output: no space left" bash -c "'$odraz' --dump - ${small[*]} >/dev/full"
    check "$name dumps into a closed pipe" refuses 1 "cannot write standard output: the pipe was closed" bash -c "set -o pipefail; '$odraz' --dump - --size 320x180 --quality draft | head -c 99 >/dev/null"
    check "$name dumps to a closed stdout" refuses 1 "cannot write standard output: it is closed" bash -c "'$odraz' --dump - ${small[*]} >&-"
    check "$name does not dump to a terminal" bash -c "script -qec '$odraz --dump - ${small[*]}' /dev/null | grep -q 'not to the terminal'"
    check "$name dumps into a file's place" refuses 1 "not a directory" "$odraz" --dump "$BUILD/CMakeCache.txt" "${small[@]}"
    check "$name dumps below nowhere" refuses 1 "no such directory" "$odraz" --dump "$WORK/no/where" "${small[@]}"
    check "$name dumps into a directory it may not write" refuses 1 "cannot write /proc/frame-000500.ppm" "$odraz" --dump /proc "${small[@]}"

    # Standard descriptors that are closed must not be taken for files
    for closed in '<&-' '>&-' '2>&-' '<&- >&- 2>&-'; do
        rm -rf "$WORK/frames"
        check "$name dumps with $closed" bash -c "'$odraz' --dump '$WORK/frames' ${small[*]} $closed && [ \$(ls '$WORK/frames' | wc -l) = 5 ] && [ \$(stat -c %s '$WORK/frames/frame-000500.ppm') = $((64 * 36 * 3 + 13)) ]"
    done
    check "$name leaves nothing half-written" bash -c "! ls -A '$WORK/frames' | grep -q part"
    check "$name makes an empty interval of no frames" bash -c "[ \$('$odraz' --dump - --from 3 --to 3 | wc -c) = 0 ]"
done
finish

# Wrong options and failing outputs give one helpful line and the right exit status; no file is half-written.
#   commandline.sh BUILD packed|safe
. "$(dirname "$0")/common.sh"
skip_unless script
unset DISPLAY
film=$BUILD/$FILM
[ "${2-}" != safe ] || film+=-safe

# The commit is unknown only where there is no repository
commit='[0-9a-f]{12}\+?'
git -C "$SOURCE" rev-parse HEAD >/dev/null 2>&1 || commit=unknown
check "--version" prints "^$FILM [0-9]+\.[0-9]+\.[0-9]+ $commit\$" "$film" --version
check "... in one line" test "$(wc -l <"$WORK/printed")" = 1
check "--help" prints "^usage" "$film" --help
for option in $(grep -oE '"--[a-z]+"' "$SOURCE/intro/options.cpp" | tr -d '"'); do
    check "... names $option" grep -qw -e "$option" "$WORK/printed"
done
check "it refuses an unknown option" refuses 2 "unknown option '--nope'" "$film" --nope
check "it refuses a time beyond the film" refuses 2 "beyond the film's end" "$film" --to 999
check "it repeats unprintable characters as ?, in one line" refuses 2 "not 'a?b?[31m'" "$film" --fps $'a\nb\e[31m'
check "--help reports a full disk" refuses 1 "no space left" bash -c 'exec "$0" --help >/dev/full' "$film"

small=(--size 64x36 --from 2 --to 2.2 --quality draft)
check "--dump reports a full disk" refuses 1 "cannot write standard output: no space left" bash -c 'exec "$0" --dump - "$@" >/dev/full' "$film" "${small[@]}"
check "... a closed pipe" refuses 1 "cannot write standard output: the pipe was closed" bash -c 'set -o pipefail; "$0" --dump - --size 320x180 --quality draft | head -c 99 >/dev/null' "$film"
not_to_terminal() { # it refuses, and writes no picture
    script -qec "${film@Q} --dump - ${small[*]}" /dev/null >"$WORK/terminal" </dev/null
    [ $? != 0 ] && grep -q 'binary data to the terminal' "$WORK/terminal" && lacks P6 "$WORK/terminal"
}
check "it does not dump to a terminal" not_to_terminal
check "--dump refuses a folder that it may not write to" refuses 1 "cannot write /proc/frame-000050.ppm" "$film" --dump /proc "${small[@]}"

# An output file must not get the number of a closed standard descriptor
five() { # the folder has five whole pictures and nothing else
    local n
    [ "$(ls -A "$WORK/frames")" = "$(printf 'frame-%06d.ppm\n' 50 51 52 53 54)" ] || return 1
    for n in 50 51 52 53 54; do [ "$(stat -c %s "$WORK/frames/frame-0000$n.ppm")" = $((64 * 36 * 3 + 13)) ] || return 1; done
}
for closed in '<&-' '>&-' '2>&-' '<&- >&- 2>&-'; do
    rm -rf "$WORK/frames"
    check "it dumps with $closed" bash -c 'exec "$0" --dump "$@" '"$closed" "$film" "$WORK/frames" "${small[@]}"
    check "... five pictures" five
done
"$film" --dump - --from 3 --to 3 >"$WORK/none"
check "an empty interval makes no frames" test $? = 0 -a ! -s "$WORK/none"
finish

# What was shown of a played film: odraz-debug records it, build/seen reads it.
#   shown.sh BUILD
. "$(dirname "$0")/display.sh"
needs_built odraz-debug
needs_built seen
start_display 320x200
list=$WORK/shown.csv
record() { timeout "$PATIENCE" "$BUILD/odraz-debug" --shown "$@" --size 160x90 --mute >"$WORK/out" 2>"$WORK/err"; }

check "plays three seconds and writes what was shown" record "$list" --from 50.5 --to 53.5
check "... and says nothing" test ! -s "$WORK/err" -a ! -s "$WORK/out"
check "... and leaves nothing beside it" test "$(ls "$WORK" | grep -c shown)" = 1
check "... which shows the film in order, nothing before its time" table "$list" \
    'if ($2 < last || ($1 >= 0 && $1 < $2)) wrong = 1; last = $2; shown += $1 >= 0; if ($4 > 2 || $5 != 160 || $6 != 90) wrong = 1' \
    '!wrong && shown > 20 && lines <= 181 && last > 53 && last < 53.5'
check "seen sums it up" prints '^flake,[0-9.]+,[0-9]+,[0-9]+,[0-9]+,' "$BUILD/seen" "$list" --summary
check "... and looks at it" prints '^flake,30,[0-9]+,0\.[0-9]+,[0-9.]+,[0-9.]+$' "$BUILD/seen" "$list" --at 51.75 --screen 160x90
check "writes to standard output" eval '"$BUILD/odraz-debug" --shown - --from 50 --to 50.5 --size 64x36 --mute | grep -q "^at,time,kind"'

# What is wrong is told in one line
debug=("$BUILD/odraz-debug" --size 64x36 --mute --from 50 --to 50.3 --shown)
check "no folder" refuses 1 "cannot write $WORK/none/list" "${debug[@]}" "$WORK/none/list"
check "a folder" refuses 1 "cannot write $WORK" "${debug[@]}" "$WORK"
check "a full disk" refuses 1 "no space left" "${debug[@]}" /dev/full
check "a closed pipe" refuses 1 "cannot write standard output" bash -c '"$@" - | true; exit ${PIPESTATUS[0]}' - "${debug[@]}"
check "a quality" refuses 2 "leave out --quality" "${debug[@]}" "$list" --quality film
check "a dump" refuses 2 "leave out --dump" "$BUILD/odraz-debug" --shown "$list" --dump "$WORK/frames"
finish

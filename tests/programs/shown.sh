# odraz-debug records the pictures that it showed while it played; build/seen judges them.
#   shown.sh BUILD
. "$(dirname "$0")/display.sh"
needs_built odraz-debug seen probe
start_display 320x200
list=$WORK/shown.csv
record() { timeout "$PATIENCE" "$BUILD/odraz-debug" --shown "$@" --size 160x90 --mute >"$WORK/out" 2>"$WORK/err"; }

check "plays three seconds and writes what was shown" record "$list" --from 50.5 --to 53.5
check "... and prints nothing" test ! -s "$WORK/err" -a ! -s "$WORK/out"
check "... and leaves no other file" test "$(ls "$WORK" | grep -c shown)" = 1
check "... which shows the film in order, nothing before its time" table "$list" \
    'if ($2 < last || ($1 >= 0 && $1 < $2)) wrong = 1; last = $2; shown += $1 >= 0; if ($4 > 2 || $5 > 160 || $6 > 90) wrong = 1' \
    '!wrong && shown > 0 && lines <= 181 && last < 53.5'
check "seen sums it up" prints '^flake,[0-9.]+,[0-9]+,[0-9]+,[0-9]+,' "$BUILD/seen" "$list" --summary
check "... and simulates it on a machine as fast" prints '^simulated,flake,[0-9.]+,[0-9]+,' \
    "$BUILD/seen" "$list" --simulate --screen 160x90 --summary --since 51.5
check "--simulate without a list" refuses 2 "--simulate needs a list" "$BUILD/seen" --machine 8 --simulate --summary
at=$(awk -F, 'NR > 1 && $1 >= 0 { printf "%.3f", $1 + 0.001; exit }' "$list") # when the first picture is on the screen
check "... and judges it" \
    prints '^flake,30,[0-9]+,0\.[0-9]+,[0-9.]+,[0-9.]+$' "$BUILD/seen" "$list" --at "$at" --screen 160x90
check "... and writes the pictures on the screen, and the reference pictures" eval \
    '"$BUILD/seen" "$list" --at "$at" --length 0.0667 --screen 160x90 --pictures "$WORK/pictures" >"$WORK/out" &&
    [ "$(ls "$WORK/pictures" | sed "s/^[0-9]*-//" | tr "\n" " ")" = "0-truth.png 0.png 1-truth.png 1.png 2-truth.png 2.png 3-truth.png 3.png " ]'

# Simulated players
players=("$BUILD/seen" --machine 8 --machine 64 --screen 640x360 --screen 1280x720)
check "each machine with each screen" eval \
    '[ "$("${players[@]}" --summary | cut -d, -f 1,2 | uniq | tr "\n" " ")" = "screen,machine 640x360,8 640x360,64 1280x720,8 1280x720,64 " ]'
check "... is judged" eval \
    '[ "$("${players[@]}" --judged 64x36 --at 52 --length 0.05 | cut -d, -f 1-4 | tr "\n" " ")" = "screen,machine,scene,sixtieths 640x360,8,flake,3 640x360,64,flake,3 1280x720,8,flake,3 1280x720,64,flake,3 " ]'
check "the page's player makes no in-betweens" eval \
    '[ "$("$BUILD/seen" --machine 16 --page 1.6 --summary | cut -d, -f 6 | sort -u | tr "\n" " ")" = "0 between " ]'
check "--page without a machine" refuses 2 "--page needs --machine" "$BUILD/seen" "$list" --page 2
check "several screens without --judged" refuses 2 "several screens need --judged" "${players[@]}"

check "writes to standard output" \
    eval '"$BUILD/odraz-debug" --shown - --from 50 --to 50.5 --size 64x36 --mute | grep -q "^at,time,kind"'
probe=("$BUILD/probe" --at 52 --size 64x36 --gap 2 --errors "$WORK/truths")
check "probe prints errors" prints '^52,2,draft edge=0.1,64,36,.*,flake,[0-9.]+$' "${probe[@]}" --setting draft,edge=0.1
check "... and keeps the film's picture by its size" test "$(ls "$WORK/truths")" = 52.0000-64x36.rgb
check "--gap without --setting" refuses 2 "--gap needs --setting" "${probe[@]}"

# Errors are reported in one line
debug=("$BUILD/odraz-debug" --size 64x36 --mute --from 50 --to 50.3 --shown)
check "a folder" refuses 1 "cannot write $WORK" "${debug[@]}" "$WORK"
check "a full disk" refuses 1 "no space left" "${debug[@]}" /dev/full
check "a dump" refuses 2 "leave out --dump" "$BUILD/odraz-debug" --shown "$list" --dump "$WORK/frames"
finish

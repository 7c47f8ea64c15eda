# odraz-debug with a stand-in for the editor of GNU Rocket (rocket/editor.pl), which this test gives orders.
. "$(dirname "$0")/display.sh"
needs_built "$FILM-debug"
skip_unless openbox xmllint perl
debug=$BUILD/$FILM-debug
cd "$WORK" || exit 1

# --- The document ---
document=$WORK/film.rocket
check "writes the tracks, without a display" env -u DISPLAY "$debug" --tracks "$document"
check "... as a well-formed document" xmllint --noout "$document"
has() { grep -qF "$1" "$document"; }
check "... with every number of a camera" eval 'for n in {eye,target}.{x,y,z} roll lens; do has "<track name=\"table.camera.tableWide:$n\">" || exit 1; done'
check "... and a scene's own tracks" has '<track name="hall:exposure">'
check "... keys are on the film's rows" eval 'sed -n "/tableWide:eye.y/,/<.track>/p" "$document" | grep -qF "row=\"160\" value=\"1.5\" interpolation=\"2\""'
check "... no two of which have the same name" test -z "$(grep '<track ' "$document" | sort | uniq -d)"
check "a missing folder" refuses 1 "cannot write $WORK/none/tracks" "$debug" --tracks "$WORK/none/tracks"

# --- An editor ---
start_display 640x400
start_window_manager
mkfifo "$WORK/orders"
perl "$SOURCE/tests/programs/rocket/editor.pl" <"$WORK/orders" >"$WORK/received" &
PIDS+=($!)
exec 7>"$WORK/orders"
order() { echo "$*" >&7; }
await grep -q port "$WORK/received"
port=$(sed -n 's/port //p' "$WORK/received")
WINDOW="^$FILM-debug "
begin "$debug" --mute --threads 1 --size 160x90 --from 20 --quality draft --rocket "127.0.0.1:$port"
[ -n "$window" ] && xdotool windowfocus --sync "$window"
received() { grep -qxF "$1" "$WORK/received"; }
check "the film connects, with its greeting" comes 'received film'
check "... offers its tracks" comes "received 'track credits:page'"
check "... as many as are in the document" test "$(grep -c '^track ' "$WORK/received")" = "$(grep -c '<track ' "$document")"
check "... and sends its row while it plays" comes '[ "$(grep -c "^row " "$WORK/received")" -ge 3 ]'
order pause 1
check "the editor pauses" comes 'titled paused'
order row 160
check "... and seeks" comes 'titled "row 160.0 "'
kept() { shot && convert "$WORK/shot.png" "rgb:$WORK/$1.rgb"; }
is() { kept now && cmp -s "$WORK/now.rgb" "$WORK/$1.rgb"; }
drawn
kept before
order open "$document"
order key table.camera.tableWide:eye.y 160 2.3 2
check "a key of the editor is seen" comes '! is before'
order key table.camera.tableWide:eye.y 160 1.5 2
check "... and the picture is the same to the bit when all keys are the film's" comes 'is before'
# Interpolations that the film does not use
order row 2
check "it seeks to the light" comes 'titled "row 2.0 "'
drawn
kept light
order key point:keyLight 0 0 0
check "a step changes the picture" comes '! is light'
drawn
kept step
order key point:keyLight 0 0 3
check "... and so does a ramp" comes '! is step'
check "... gives another picture than a smooth track" eval '! is light'
order key point:keyLight 0 0 2
check "... which is the film's" comes 'is light'
order row 168
check "it seeks again" comes 'titled "row 168.0 "'

# --- Keys set in the window ---
press Right
check "the film seeks, too" comes 'titled "row 172.0 "'
check "... and sends its row to the editor" comes "received 'row 172'"
drawn
kept film
xdotool keydown --window "$window" w
check "flies" comes '! is film'
xdotool keyup --window "$window" w
press r
check "key R: the script's view again" comes 'is film'
xdotool keydown --window "$window" d
comes '! is film'
xdotool keyup --window "$window" d
drawn
kept flown
cp "$WORK/shot.png" "$WORK/flown.png"
press k
check "a key is set" comes 'titled "key set on row" && titled "172"'
# The film's keys have few bits (PATH(kTableWide, 8) in show/film.keys), so the key keeps the view approximately
error() { shot && compare -metric RMSE "$WORK/flown.png" "$WORK/shot.png" null: 2>&1 | sed 's/.*(\(.*\))/\1/'; }
check "... which keeps the view approximately" comes '! is film && less "$(error)" 0.1'
press r
check "... which is the script's view now" comes '! is film && less "$(error)" 0.1'
echo "somebody's work" >"$FILM.rocket"
press x
check "an existing file is not overwritten" comes 'titled "$FILM.rocket already exists"'
check "... and is unchanged" grep -qx "somebody's work" "$FILM.rocket"
rm "$FILM.rocket"
press x
check "key X writes the document" comes '[ -s "$FILM.rocket" ]'
check "... with that key, for eye and target" test "$(grep -A6 'tableWide:\(eye\|target\)' "$FILM.rocket" | grep -c 'row="172"')" = 6
press shift+k
check "the key is removed" comes 'is film'

rm "$FILM.rocket"
order save
check "the editor's order writes it, too" comes '[ -s "$FILM.rocket" ]'

# (rocket_test tests editors that come and go, and that send nonsense)
order hang-up
check "the film connects again" comes '[ "$(grep -cx film "$WORK/received")" = 2 ]'
check "the picture is the film's own" comes 'is film'
check "nothing that the editor received was nonsense" eval '! grep -q "nonsense\|stranger" "$WORK/received"'
xdotool key --window "$window" Escape 2>/dev/null
check "it quits" ended "$pid"
finish

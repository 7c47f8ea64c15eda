# Live editing: a copy of the house is built, its odraz-debug started, and its sources changed while it plays.
. "$(dirname "$0")/../common.sh"
. "$SOURCE/tests/programs/display.sh"
skip_unless git cmake openbox
house=$WORK/house
mkdir "$house"
(cd "$SOURCE" && git ls-files -z | xargs -0 cp --parents -t "$house") || exit 1
(cd "$house" && git init -q) # its version is looked up at every build
check "configures a copy" cmake -S "$house" -B "$house/build" -G Ninja >/dev/null
check "builds its odraz-debug" cmake --build "$house/build" --target "$FILM-debug" >/dev/null
start_display 800x500
openbox >/dev/null 2>&1 &
PIDS+=($!)

seen() { window=$(xdotool search --onlyvisible --name "^$FILM-debug " 2>/dev/null | tail -n 1) && [ -n "$window" ]; }
begin "$house/build/$FILM-debug" --mute --from 20 --size 320x180
check "it plays" test -n "$window"
xdotool windowfocus --sync "$window" key space
paused() { xdotool getwindowname "$window" | grep -q paused; }
check "... and pauses" await paused
kept() { shot && cp "$WORK/shot.png" "$WORK/$1.png"; }
sleep 1
kept before
news() { grep -c 'new since' "$WORK/err"; }
# changes FILE SED: saves it, and waits until it is shown
changes() {
    local before=$(news)
    sed -i "$2" "$house/intro/$1"
    await eval "[ \"\$(news)\" -gt $before ]" && sleep 1
}
scene=show/scenes/table.cpp
cp "$house/intro/$scene" "$WORK/kept.cpp"
check "a scene that is changed is shown" changes $scene 's/sphere({0, 0.8f, 0}, 0.8f, kSilver)/sphere({0, 0.8f, 0}, 0.8f, kRed)/'
kept after
check "... which is another picture" eval '! cmp -s "$WORK/before.png" "$WORK/after.png"'
echo "this is no C++" >>"$house/intro/$scene"
check "what does not compile is told" await grep -q "intro/$scene:[0-9:]* error: " "$WORK/err"
sleep 1
kept wrong
upper() { convert "$WORK/$1.png" -crop 320x100+0+0 +repage "rgb:$WORK/$1.rgb"; }
check "... over the picture, which stays" eval 'upper after && upper wrong && cmp "$WORK/after.rgb" "$WORK/wrong.rgb" && ! cmp -s "$WORK/after.png" "$WORK/wrong.png"'
back() { local before=$(news); cp "$WORK/kept.cpp" "$house/intro/$scene"; await eval "[ \"\$(news)\" -gt $before ]" && sleep 1 && kept again; }
check "what is changed back" back
check "... is the same picture as before" cmp "$WORK/before.png" "$WORK/again.png"
check "new music" changes show/score.cpp 's/\[kTable\] = "\([A-G]\)/[kTable] = "C/'
check "another hall is solved in the background" changes show/hall_model.cpp 's/kShaft, 0\.46f/kShaft, 0.4f/'
check "... which is told" grep -q 'the hall is solved anew' "$WORK/err"
check "it is still there" kill -0 $pid
sed -n 's/.*: new since/    shown:/p' "$WORK/err"
xdotool key --window "$window" Escape
check "it leaves" eval 'ended $pid'
finish

# Live editing: builds a copy of the repository, starts its odraz-debug, and changes the sources while it plays.
. "$(dirname "$0")/../common.sh"
. "$SOURCE/tests/programs/display.sh"
skip_unless git cmake openbox wmctrl convert
house=$WORK/house
copy_sources "$house"
(cd "$house" && git init -q && cp -r intro "$WORK/kept") # every build looks up its version
check "configures a copy" cmake -S "$house" -B "$house/build" -G Ninja >/dev/null
check "builds its $FILM-debug" cmake --build "$house/build" --target "$FILM-debug" >/dev/null
start_display 800x500
start_window_manager
export ALSA_CONFIG_PATH=$WORK/alsa.conf
unset PULSE_SERVER
cat >"$ALSA_CONFIG_PATH" <<END
pcm.!default { type file slave.pcm "nothing" file "$WORK/played" format "raw" }
pcm.nothing { type null }
END

# --- The program and its reports ---
WINDOW="^$FILM-debug "
starts() { # starts SECONDS OPTION...: starts odraz-debug at this time of the film
    begin "$house/build/$FILM-debug" --size 320x180 --from "$@"
    [ -n "$window" ] && xdotool windowfocus --sync "$window"
}
leaves() { press Escape 2>/dev/null; ended "$pid"; } # (its window may be gone before the key is released)
leaves_unsaved() { press Escape && comes 'titled "not saved"' && leaves; }
reported() { grep -q "$1" <(tail -n +$((marked + 1)) "$WORK/err"); }
mark() { marked=$(wc -l <"$WORK/err"); }
edit() { sed -i "$2" "$house/intro/$1" && ! cmp -s "$house/intro/$1" "$WORK/kept/$1"; } # edit FILE SED: edits a source with sed
restore() { cp "$WORK/kept/$1" "$house/intro/$1"; }
# shows COMMAND...: runs the command, and waits until the picture of the new sources is shown
shows() { mark && "$@" && comes 'reported "shown"' && drawn; }
changes() { # changes NAME FILE SED: edits the file, waits for another picture, and keeps it as NAME
    shows edit "$2" "$3" && comes '! same before' && drawn && kept "$1"
}
goes_back() { shows restore "$1" && comes 'same before'; }
same() { kept again && cmp -s "$WORK/$1.png" "$WORK/again.png"; }
kept() { shot && cp "$WORK/shot.png" "$WORK/$1.png"; }
fly() {
    xdotool keydown --window "$window" d
    comes '! same before' && drawn
    xdotool keyup --window "$window" d
    drawn
}
unreported() { sleep 5 && drawn; } # a report covers the picture for four seconds
pauses() { press space && comes 'titled paused' && drawn && kept before; }

# --- Sound ---
loud() { [ "$(tail -c 40000 "$WORK/played" | od -An -v -td2 -w2 | awk '{ a = $1 < 0 ? -$1 : $1; if (a > most) most = a } END { print (most > 300) }')" = "$1" ]; }
check "it plays" starts 20
[ -n "$window" ] || finish
check "... with sound" comes 'loud 1'
edit show/score.cpp 's/^void playRow(.*{$/& return;/'
check "a score without notes is silent" comes 'loud 0'
restore show/score.cpp
check "... and the first score is heard again" comes 'loud 1'

# --- Pictures ---
table=show/scenes/table.cpp
check "it quits" leaves
check "it plays again" starts 17 # the shot that is changed ends at 24 s
check "it pauses" pauses
check "a scene that is changed is shown" changes red "$table" 's/0.8f, kSilver)/0.8f, kRed)/'
mark
echo "this is no C++" >>"$house/intro/$table"
check "a compiler error is reported" comes 'reported "intro/$table:[0-9:]* error: "'
drawn
kept wrong
upper() { convert "$WORK/$1.png" -crop 320x60+0+0 +repage "rgb:$WORK/$1.rgb"; }
stands() { upper red && upper wrong && cmp "$WORK/red.rgb" "$WORK/wrong.rgb" && ! cmp -s "$WORK/red.png" "$WORK/wrong.png"; }
check "... over the picture, which stays" stands
check "the first source gives the first picture again" goes_back "$table"
check "a changed material is shown" changes material show/materials.cpp 's/diffuse = 0.375f/diffuse = 0.9f/'
check "... and back" goes_back show/materials.cpp
check "a changed event is shown" changes event show/events.h 's/{kBallsSetOff, *kTable, *16,/{kBallsSetOff, kTable, 4,/'
check "... and back" goes_back show/events.h
fly
press k
check "a key is set" comes 'titled "key set on row"'
unreported
check "... which is another view" eval '! same before'
kept before
check "a changed scene is shown from this view" changes viewed "$table" 's/0.8f, kSilver)/0.8f, kRed)/'
check "... and back" goes_back "$table"
check "it quits" leaves_unsaved
check "... and reports nothing else" eval '! grep -v " shown \| error: " "$WORK/err"'

# --- Edits are saved into the sources ---
film=$house/intro/show/film.keys
flies() { fly && press k && comes 'titled "key set on row"' && unreported && kept edited; } # flies, and sets a key
check "it plays again" starts 20 --mute
check "it pauses" pauses
on_row() { # setting a key moves the film to a row
    press k && comes 'titled "key set on row"' && press ctrl+z && comes 'titled undone' && unreported && kept before
}
check "... at a row" on_row
check "a key is set by hand" flies
row=$(xdotool getwindowname "$window" | sed -n 's/.* row \([0-9]*\)\.0 .*/\1/p')
# S without Ctrl flies backwards, and Ctrl may be released first
saves() {
    mark
    xdotool keydown --window "$window" ctrl keydown --window "$window" s keyup --window "$window" ctrl
    drawn
    xdotool keyup --window "$window" s
    comes 'reported "saved film.keys"'
}
check "it is saved" saves
check "... built and shown" comes 'reported "shown"'
check "... the same picture" comes 'same edited'
changed_lines() { diff "$WORK/kept/show/film.keys" "$film" | grep -c '^[<>]'; }
check "... and one key is new in the source" test "$(changed_lines)" = 1
check "the film is built from it" cmake --build "$house/build" --target "$FILM-safe" >/dev/null
"$house/build/$FILM-safe" --dump "$WORK/frames" --fps 8 --from "$(awk "BEGIN { print $row / 8 }")" --to "$(awk "BEGIN { print $row / 8 + 0.1 }")" --size 320x180 --quality play
equal() { convert "$WORK/edited.png" -depth 8 "rgb:$WORK/seen.rgb" && convert "$WORK/frames/frame-$(printf %06d "$row").ppm" -depth 8 "rgb:$WORK/dumped.rgb" && cmp "$WORK/seen.rgb" "$WORK/dumped.rgb"; }
check "... and dumps the picture that was seen, to the bit" equal
# (keys_test tests files that other programs change meanwhile)
check "another key" flies
wmctrl -i -c "$window"
check "closing the window does not lose edits" comes 'titled "not saved"'
check "... but ESC after it does" leaves
restore show/film.keys

# --- The hall ---
check "it plays in the hall" starts 95 --mute
check "it pauses" pauses
mark
edit show/hall_model.cpp 's/kShaft, 0\.46f/kShaft, 0.4f/'
check "another hall is solved" comes 'reported "solving the hall again"'
drawn
kept solving
check "... over the picture, with a bar" eval '! cmp -s "$WORK/before.png" "$WORK/solving.png"'
check "... shown when it is done" comes 'reported "shown"'
check "a material of the hall" changes plaster show/materials.cpp 's/kPlaster = {.texture = plaster(linear(194, 187, 174/kPlaster = {.texture = plaster(linear(194, 57, 44/'
check "... is solved, too" reported "solving the hall again"
again() {
    restore show/materials.cpp && comes 'reported "solving the hall again"' && mark &&
        restore show/hall_model.cpp && comes 'reported "solving the hall again"'
}
check "a hall that is changed again while it is solved" shows again
check "... gives the first picture again" comes 'same before'
check "a change to its picture alone" changes dust show/hall.cpp 's/kDust = 0.017f/kDust = 0.17f/'
check "... needs no solving" eval '! reported "solving the hall"'
sed -n 's/.*: shown/    shown:/p' "$WORK/err"
check "... and back" goes_back show/hall.cpp
mark
edit show/hall_model.cpp 's/kShaft, 0\.46f/kShaft, 0.4f/'
check "it is solved" comes 'reported "solving the hall again"'
check "it quits while it solves" leaves
check "it plays again" starts 95 --mute
restore show/hall_model.cpp
check "it compiles" comes 'titled building'
check "it quits while it compiles" leaves
check "... and so do its compilers" await eval "! pgrep -f '^[^ ]*(ninja|cc1plus|cmake) .*$house' >/dev/null"
finish

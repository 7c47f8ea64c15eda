# The film in a window: it starts, draws, resizes, fills the screen, and ends.
. "$(dirname "$0")/display.sh"
skip_unless xprop openbox wmctrl
packed=$BUILD/odraz odraz=$BUILD/odraz-safe # the same program, which starts without unpacking

fills_the_screen() { xprop -id "$window" _NET_WM_STATE | grep -q FULLSCREEN; }
load() { begin "$@" --threads 1 && await focused; } # load PROGRAM OPTION...

start_display 1000x700

# Without a window manager the film makes its window as large as the screen, and takes the keyboard
check "plays on the full screen" play "$packed" --from 100
check_full_screen
check "ESC quits" leaves xdotool key Escape

# Loading: a bar grows, and ESC ends the film
check "opens a window" load "$packed"
check "a bar grows while it loads" grows $pid
check "ESC quits while it loads" leaves xdotool key Escape

check "plays in a window" play "$odraz" --window --size 640x360 --from 50 --stats
check "its window has the film's size" measures 640 360
looks() { import -window "$window" rgb:- | md5sum; }
stands() { [ "$(looks)" = "$(sleep 0.4; looks)" ]; }
moves() { ! stands; }
xdotool key space
check "space pauses" await stands
check "... and it stays paused" stands
xdotool key space
check "... and space goes on" await moves
xdotool windowsize "$window" 900 300
check "draws at another size" await is_black 180x300+0+0
check "with bars at both sides" await is_black 180x300+720+0
check "... and the picture between" await is_bright
xdotool windowsize "$window" 3 2
check "shrinks to 3 x 2 pixels" await measures 3 2
check "... and plays on" worked $pid 30
xdotool windowsize "$window" 700 500
check "... and is drawn when it is larger again" await is_black 700x52+0+0
check "... with a picture" await is_bright
check "Alt-F4 quits" leaves xdotool key alt+F4
check "--stats names the scene" grep -qE '^flake +[1-9]' "$WORK/out"
check "nothing is printed on standard error" test ! -s "$WORK/err"

check "plays to its end by itself" prints ^credits timeout "$PATIENCE" "$packed" --window --size 320x180 --from 161 --stats

check "where OpenGL has no integers, only the hall's scenes are left out" \
    play env MESA_EXTENSION_OVERRIDE=-GL_EXT_texture_integer "$odraz" --window --size 320x180 --from 151
check "... and one line names the cause" grep -q 'cannot light the hall' "$WORK/err"
check "... and ESC quits" leaves xdotool key Escape

# Missing things are also reported in a small window
clicked_away() { xdotool mousemove 60 60 click 1; sleep 0.1; gone $pid; }
leaves_by_click() {
    await clicked_away
    ended $pid
    [ $? = 1 ]
}
check "a missing library opens a small window" begin env LD_LIBRARY_PATH="$(lacking libGL.so.1)" "$packed"
check "... which a click ends with status 1" leaves_by_click
check "... and reports it on standard error too" grep -q 'libGL.so.1 is missing' "$WORK/err"
check "a missing driver opens one, too" begin env LIBGL_DRIVERS_PATH=/none "$odraz"
check "... which a click ends with status 1" leaves_by_click
check "... and Mesa's own lines about it are not printed" test "$(wc -l <"$WORK/err")" = 1

# Under a window manager
start_window_manager
check "plays under a window manager" play "$odraz" --from 30
check "it requests the full screen" await fills_the_screen
check "... and gets it" await measures 1000 700
check "... and draws there" await is_bright
check "ESC quits there" leaves xdotool key Escape
check "opens a window there" load "$packed" --window --size 640x360
check "... managed by the window manager" await managed
check "the close button quits while it loads" leaves wmctrl -i -c "$window"
check "plays in a window there" play "$odraz" --window --size 640x360 --from 30
check "... managed by the window manager" await managed
check "the close button quits" leaves wmctrl -i -c "$window"

# The display ends while the film plays
check "plays once more" play "$odraz" --window --size 320x180 --from 30
kill "${PIDS[0]}"
ended $pid
check "a display that goes away ends it with status 1" test $? = 1
check "... and one line" grep -qx 'odraz: the display went away' "$WORK/err"

# Displays that lack something
start_display 640x360 -extension MIT-SCREEN-SAVER
check "plays where the screen saver cannot be held off" "$odraz" --window --mute --from 4 --to 4.5 2>"$WORK/err"
check "... silently" test ! -s "$WORK/err"
start_display 640x360x16
check "a screen of 16 bits opens a small window" begin "$odraz" --window --mute --from 4
check "... which a click ends with status 1" leaves_by_click
check "... and reports what to do" grep -q 'too few colours: set it to 24 bits' "$WORK/err"
finish

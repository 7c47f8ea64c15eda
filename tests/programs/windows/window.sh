# The film for Windows in a window, by Wine: it starts, draws, fills a screen of another aspect, is resized to tiny and
# odd sizes, is moved and minimised, and ends.
. "$(dirname "$0")/wine.sh"
skip_unless openbox wmctrl
film=$BUILD/odraz.exe

load() { begin "$wine" "$film" "$@"; }
resized() { xdotool windowsize "$window" "$1" "$2"; }
to_window() { xdotool windowfocus --sync "$window" && xdotool key "$@"; }
start_display 1000x700

check "plays on the full screen" play --from 100
check_full_screen
check "ESC quits" leaves to_window Escape

# While loading, a bar grows and the film can be ended, both during unpacking and after it
check "opens a window" load
check "a bar grows while it loads" grows
check "ESC quits while it loads" leaves to_window Escape

check "plays in a window" play --window --size 640x360 --from 60 --stats
check "its window has the film's size" measures 640 360
resized 900 300
check "draws at another size" await is_black 180x300+0+0
check "with bars at both sides" await is_black 180x300+720+0
check "... and the picture between" await is_bright
check "Alt-F4 quits" leaves to_window alt+F4
check "--stats names the scene" grep -qE '^flake +[1-9]' "$WORK/out"
check "plays at an odd size" play --mute --window --size 641x359 --from 60
check "... which its window has" measures 641 359
resized 3 2
check "shrinks to 3 x 2 pixels" await measures 3 2
check "... and plays on" worked $pid 30
often() {
    local i
    for i in {1..60}; do resized $((20 + i * 13 % 700)) $((20 + i * 29 % 500)) || return; done
    resized 700 500
}
check "is resized often and quickly" often
check "... and has the last of the sizes" await measures 700 500
check "... with bars above" await is_black 700x52+0+0
check "... and below" await is_black 700x52+0+448
check "... and a picture" await is_bright
xdotool windowmove "$window" 250 150
check "is moved" await eval 'xwininfo -id "$window" | grep -q "Absolute upper-left X: *250"'
check "... and draws" await is_bright
check "ESC quits" leaves to_window Escape
check "plays to its end by itself" prints ^credits timeout "$PATIENCE" "$wine" "$film" --window --size 320x180 --from 161 --mute --stats
film=$BUILD/odraz-safe.exe
check "without winmm.dll it plays in silence" prints ^credits env WINEDLLOVERRIDES="winmm=;$WINEDLLOVERRIDES" timeout "$PATIENCE" "$wine" "$film" --window --size 320x180 --from 161 --stats

# Under a window manager
start_window_manager
check "plays in a window there" play --mute --window --size 640x360 --from 60
check "... managed by the window manager" await managed
hidden() { xwininfo -id "$window" | grep -q 'Map State: IsUn'; }
xdotool windowminimize "$window"
check "is minimised" await hidden
check "... and plays on" worked $pid 30
wmctrl -i -a "$window"
check "is restored" await eval '! hidden'
check "... as large as before" await measures 640 360
resized 640 500
check "... and can be resized, with bars above" await is_black 640x69+0+0
check "... and below" await is_black 640x69+0+431
check "... and draws" await is_bright
check "the close button quits" leaves wmctrl -i -c "$window"

# Missing things are reported on standard error, or in a message box if there is none
check "an OpenGL that is too old is refused" refuses 1 "no OpenGL 3.3 on this display: install" env MESA_GL_VERSION_OVERRIDE=2.1 "$wine" "$film"
check "... one without opengl32.dll, too" refuses 1 "no OpenGL 3.3 on this display: install" env WINEDLLOVERRIDES="opengl32=;$WINEDLLOVERRIDES" "$wine" "$film"
check "... in a box where there is no standard error, with status 1" \
    boxed 1 odraz-safe.exe without_stderr env MESA_GL_VERSION_OVERRIDE=2.1 "$wine" "$film"
check "without a display" refuses 1 "no display: log in to one" env -u DISPLAY "$wine" "$film" --window

finish

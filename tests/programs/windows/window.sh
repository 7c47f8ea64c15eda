# The film on Windows in a window, shown by Wine: it starts, draws, resizes, fills the screen, and ends.
. "$(dirname "$0")/wine.sh"
. "$(dirname "$0")/../display.sh"
film=$BUILD/odraz.exe

load() { begin "$wine" "$film" "$@"; }
leaves() { # leaves COMMAND...: the command ends the film, with status 0
    "$@" >/dev/null 2>&1
    ended $pid
}
to_window() { xdotool windowfocus --sync "$window" && xdotool key "$@"; }
start_display 1000x700

check "plays on the full screen" play --from 100
check_full_screen
check "ESC leaves" leaves to_window Escape

# While loading, a bar grows and the film can be ended, both during unpacking and after it
check "opens a window" load
check "a bar grows while it loads" grows 3
check "ESC leaves" leaves to_window Escape
check "opens a window" load --from 100
check "ESC leaves while it loads" leaves to_window Escape

check "plays in a window" play --window --size 640x360 --from 60 --stats
check "its window has the film's size" measures 640 360
xdotool windowsize "$window" 900 300
check "draws at another size" await is_black 180x300+0+0
check "with bars at both sides" await is_black 180x300+720+0
check "... and the picture between" await is_bright
check "Alt-F4 leaves" leaves to_window alt+F4
check "--stats names the scene" grep -qE '^flake +[1-9]' "$WORK/out"
check "plays to its end by itself" prints ^credits timeout "$PATIENCE" "$wine" "$film" --window --size 320x180 --from 161 --mute --stats
film=$BUILD/odraz-safe.exe
check "without winmm.dll it plays in silence" prints ^credits env WINEDLLOVERRIDES="winmm=;$WINEDLLOVERRIDES" timeout "$PATIENCE" "$wine" "$film" --window --size 320x180 --from 161 --stats
check "odraz-safe plays too" prints ^credits timeout "$PATIENCE" "$wine" "$film" --window --size 320x180 --from 161 --mute --stats

# Under a window manager
skip_unless openbox wmctrl
start_window_manager
check "plays in a window there" play --window --size 640x360 --from 30
check "... managed by the window manager" await managed
check "the close button leaves" leaves wmctrl -i -c "$window"

# Missing things are reported on standard error, or in a box if there is none
check "an OpenGL that is too old is refused" refuses 1 "no OpenGL 3.3 on this display: install" env MESA_GL_VERSION_OVERRIDE=2.1 "$wine" "$film"
check "... one without opengl32.dll, too" refuses 1 "no OpenGL 3.3 on this display: install" env WINEDLLOVERRIDES="opengl32=;$WINEDLLOVERRIDES" "$wine" "$film"
MESA_GL_VERSION_OVERRIDE=2.1 "$wine" "$film" 2>&- &
pid=$!
PIDS+=($pid)
check "... in a box where there is no standard error" await eval "xdotool search --onlyvisible --class 'odraz-safe.exe' >/dev/null"
closes() {
    xdotool search --onlyvisible --class 'odraz-safe.exe' windowfocus key Return 2>/dev/null
    gone $pid
}
check "... which Return closes" await closes
wait $pid
check "... with status 1" test $? = 1
check "without a display" refuses 1 "no display: log in to one" env -u DISPLAY "$wine" "$film" --window
finish

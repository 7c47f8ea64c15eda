# The film's window on Windows: tiny and odd sizes, quick resizing, moving, minimising; and a display of another aspect.
. "$(dirname "$0")/wine.sh"
. "$(dirname "$0")/../display.sh"
skip_unless openbox wmctrl
film=$BUILD/odraz-safe.exe
load() { begin "$wine" "$film" --mute "$@"; }
leaves() { xdotool windowfocus --sync "$window" key Escape && ended $pid; }
resized() { xdotool windowsize "$window" "$1" "$2"; }

start_display 1000x700
check "plays at an odd size" play --window --size 641x359 --from 60
check "... which its window has" measures 641 359
resized 1 1
check "gets as tiny as can be" await measures 1 1
check "... and plays on" worked $pid 30
resized 3 2
check "gets tiny" await measures 3 2
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
check "ESC leaves" leaves

# Under a window manager
start_window_manager
check "plays there" play --window --size 640x360 --from 60
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
check "ESC leaves" leaves

# A display that is higher than wide. Restart Wine, because it keeps the first display that it saw
"$wine_server" -k
"$wine_server" -f -p </dev/null >/dev/null 2>&1 &
start_display 500x700
check "fills a high display" play --from 60
check "... whole" measures 500 700
check "... with bars above" await is_black 500x208+0+0
check "... and below" is_black 500x208+0+492
check "ESC leaves" leaves
finish

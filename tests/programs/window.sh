# The film in a window: it starts, draws, resizes, fills the screen, and leaves at once when asked.
. "$(dirname "$0")/common.sh"
skip_unless Xvfb xdotool xprop xwininfo import identify openbox wmctrl

start_display() { # start_display WIDTHxHEIGHT: sets DISPLAY
    # (it resets itself when its last client leaves, and then refuses the next one for a moment)
    Xvfb -noreset -displayfd 5 -screen 0 "$1x24" -nolisten tcp 5>"$WORK/display" >/dev/null 2>&1 &
    PIDS+=($!)
    for _ in $(seq 100); do [ -s "$WORK/display" ] && break; sleep 0.1; done
    DISPLAY=:$(cat "$WORK/display")
    export DISPLAY
    : >"$WORK/display"
}
play() { # play OPTION...: sets pid and window
    "$odraz" "$@" >"$WORK/out" 2>"$WORK/err" &
    pid=$!
    PIDS+=($pid)
    window=
    for _ in $(seq 100); do
        window=$(xdotool search --onlyvisible --name '^odraz$' 2>/dev/null | tail -n 1) && [ -n "$window" ] && break
        sleep 0.05
    done
    [ -n "$window" ] || return 1
    # It is unpacked and the hall is solved first
    for _ in $(seq 80); do is_bright "$window" && return 0; sleep 0.2; done
    return 1
}
brightness() { import -window "$1" "$WORK/shot.png" && identify -format '%[fx:mean]' "$WORK/shot.png"; }
is_bright() { awk "BEGIN { exit !($(brightness "$1") > 0.1) }"; }
gone_within() { # gone_within MILLISECONDS COMMAND...: asks by the command, expects exit status 0 in time
    local limit=$1 begin end
    shift
    begin=$(date +%s%N)
    "$@" >/dev/null 2>&1
    for _ in $(seq 2000); do kill -0 $pid 2>/dev/null || break; sleep 0.001; done
    end=$(date +%s%N)
    wait $pid
    local status=$?
    echo "    left after $(((end - begin) / 1000000)) ms, status $status"
    [ $status = 0 ] && [ $(((end - begin) / 1000000)) -le "$limit" ]
}
# The limit is 100 ms; asking and looking take their time too, on a busy machine more
LIMIT=250

odraz=$BUILD/odraz
start_display 1000x700

# Without a window manager: full screen by size alone, with the keyboard
check "plays on the full screen" play --from 100
check "its window is as large as the screen" bash -c "xwininfo -id $window | grep -q 'geometry 1000x700+0+0'"
check "it draws" is_bright "$window"
check "the picture changes" bash -c "import -window $window '$WORK/1.png'; sleep 0.7; import -window $window '$WORK/2.png'; ! cmp -s '$WORK/1.png' '$WORK/2.png'"
# 1000x700 is taller than 16:9: 68 or 69 black rows above and below
bar() { import -window "$window" -crop "1000x${2}+0+$1" "$WORK/bar.png" && identify -format '%[fx:maxima]' "$WORK/bar.png" | grep -qx 0; }
check "the aspect is kept, bars are black" bar 0 67
check "below too" bar 633 67
check "... and the picture is not" bash -c "! identify -format '%[fx:mean]' '$WORK/shot.png' | grep -qx 0"
check "ESC leaves" gone_within $LIMIT xdotool key Escape

# Loading: a bar that grows, and that can be left
load() { # load OPTION...: as play, but returns as soon as there is a window
    local begin=$(date +%s%N)
    "$odraz" "$@" >"$WORK/out" 2>"$WORK/err" &
    pid=$!
    PIDS+=($pid)
    window=
    for _ in $(seq 200); do
        window=$(xdotool search --onlyvisible --name '^odraz$' 2>/dev/null | tail -n 1) && [ -n "$window" ] && { echo "    seen after $((($(date +%s%N) - begin) / 1000000)) ms"; return 0; }
        sleep 0.02
    done
    return 1
}
grows() { # the share of the window's middle row that is copper, until the film comes
    local before=0 now steps=0
    for _ in $(seq 12); do
        import -window "$window" -crop 1000x1+0+350 "$WORK/row.png"
        # the film begins with black, the bar ends full
        now=$(identify -format '%[fx:int(1000*mean.r)]' "$WORK/row.png")
        [ "$now" -gt "$before" ] && steps=$((steps + 1))
        [ "$now" -lt "$before" ] && break
        before=$now
    done
    echo "    the bar was seen to grow $steps times"
    [ $steps -ge 3 ]
}
check "opens a window" load
check "a bar grows while it loads" grows
check "ESC leaves" gone_within $LIMIT xdotool key Escape
check "opens a window" load --from 100
sleep 0.2
check "ESC leaves while it loads" gone_within $LIMIT xdotool key Escape
check "plays what needs no loading at once" bash -c "timeout 5 '$odraz' --window --size 320x180 --from 161.9 --stats | grep -qE '^first picture after [01]\.'"

check "plays in a window" play --window --size 640x360 --from 60 --stats
check "its window has the film's size" bash -c "xwininfo -id $window | grep -qE 'Width: 640'"
xdotool windowsize "$window" 900 300
sleep 0.6
check "draws at another size" is_bright "$window"
side() { import -window "$window" -crop "180x300+$1+0" "$WORK/side.png" && identify -format '%[fx:maxima]' "$WORK/side.png" | grep -qx 0; }
check "with bars at the sides" side 0
xdotool windowsize "$window" 3 2
sleep 0.4
check "survives a tiny window" kill -0 $pid
xdotool windowsize "$window" 700 500
sleep 0.4
check "Alt-F4 leaves" gone_within $LIMIT xdotool key alt+F4
check "--stats tells of the scene" grep -qE '^flake +[1-9]' "$WORK/out"
check "nothing is said on standard error" test ! -s "$WORK/err"

check "plays to its end by itself" bash -c "timeout 20 '$odraz' --window --size 320x180 --from 161 --stats | grep -q ^credits"
check "odraz-safe plays too" bash -c "timeout 20 '$BUILD/odraz-safe' --window --size 320x180 --from 161 --stats | grep -q ^credits"

# What is missing is shown in a small window too
mkdir -p "$WORK/libs"
echo "not a library" >"$WORK/libs/libGL.so.1"
LD_LIBRARY_PATH=$WORK/libs "$odraz" 2>"$WORK/err" &
pid=$!
PIDS+=($pid)
sleep 1
window=$(xdotool search --onlyvisible --name '^odraz$' | tail -n 1)
check "a missing library opens a small window" test -n "$window"
xdotool mousemove 60 60 click 1
sleep 0.3
wait $pid
check "... which leaves with status 1" test $? = 1
check "... and says it on standard error too" grep -q 'libGL.so.1 is missing' "$WORK/err"

MESA_GL_VERSION_OVERRIDE=2.1 "$odraz" 2>"$WORK/err" &
pid=$!
PIDS+=($pid)
sleep 1
check "an OpenGL that is too old opens one too" xdotool search --onlyvisible --name '^odraz$'
xdotool mousemove 60 60 click 1
sleep 0.3
wait $pid
check "... which leaves with status 1" test $? = 1
check "... and says what to do" grep -q 'no OpenGL 3.3 on this display: install' "$WORK/err"

begin=$(date +%s)
check "a dump tells its script, without a window" refuses 1 "not enough memory" bash -c "ulimit -v 300000; exec '$odraz' --dump - --size 7680x4320"
check "... at once" test $(($(date +%s) - begin)) -le 5

# Under a window manager
openbox >/dev/null 2>&1 &
PIDS+=($!)
sleep 1
check "plays under a window manager" play --from 100
check "it asks for the full screen" bash -c "xprop -id $window _NET_WM_STATE | grep -q FULLSCREEN"
check "it gets it" bash -c "xwininfo -id $window | grep -q 'Width: 1000' && xwininfo -id $window | grep -q 'Height: 700'"
check "it draws there" is_bright "$window"
check "ESC leaves there" gone_within $LIMIT xdotool key Escape
check "opens a window there" load --window --size 640x360 --from 100
sleep 0.2
check "the close button leaves while it loads" gone_within $LIMIT wmctrl -i -c "$window"
check "plays in a window there" play --window --size 640x360 --from 30
check "the close button leaves" gone_within $LIMIT wmctrl -i -c "$window"
check "plays in a window again" play --window --size 640x360 --from 30
check "the window manager's Alt-F4 leaves" gone_within $LIMIT xdotool key alt+F4

# The display goes away under a playing film
check "plays once more" play --window --size 320x180 --from 30
kill "${PIDS[0]}"
sleep 0.5
wait $pid
check "a display that goes away ends it with status 1" test $? = 1
check "... and one line" grep -qx 'odraz: the display went away' "$WORK/err"
finish

# Sourced by tests of the film in a window: a display of their own, and what is on it.
declare -F check >/dev/null || . "$(dirname "$0")/common.sh"
skip_unless Xvfb xdotool xwininfo import identify

start_display() { # start_display WIDTHxHEIGHT[xDEPTH] OPTION...: sets DISPLAY
    # (it resets itself when its last client leaves, and then refuses the next one for a moment)
    local screen=$1
    [[ $screen = *x*x* ]] || screen+=x24
    shift
    Xvfb -noreset -displayfd 5 -screen 0 "$screen" -nolisten tcp "$@" 5>"$WORK/display" >/dev/null 2>&1 &
    PIDS+=($!)
    await test -s "$WORK/display" || exit 1
    DISPLAY=:$(cat "$WORK/display")
    export DISPLAY
    : >"$WORK/display"
}

# --- What is on the display ---
seen() { window=$(xdotool search --onlyvisible --name '^odraz$' 2>/dev/null | tail -n 1) && [ -n "$window" ]; }
focused() { [ "$(xdotool getwindowfocus -f)" = "$window" ]; }
measures() { # measures WIDTH HEIGHT
    local told
    told=$(xwininfo -id "$window") && grep -q "Width: $1\$" <<<"$told" && grep -q "Height: $2\$" <<<"$told"
}
shot() { import -window "$window" "$@" "$WORK/shot.png"; }
measured() { identify -format "%[fx:$1]" "$WORK/shot.png"; }
is_bright() { shot && less 0.1 "$(measured mean)"; } 2>/dev/null
is_black() { shot -crop "$1" && [ "$(measured maxima)" = 0 ]; } # is_black WIDTHxHEIGHT+X+Y

begin() { # begin PROGRAM OPTION...: sets pid and window, once it is there
    local began=${EPOCHREALTIME/[.,]/}
    "$@" >"$WORK/out" 2>"$WORK/err" &
    pid=$!
    PIDS+=($pid)
    await eval "seen || gone $pid"
    seen && echo "    seen after $(((${EPOCHREALTIME/[.,]/} - began) / 1000)) ms"
}

# The film on the full screen of a display of 1000x700, which is taller than 16:9: 68 or 69 black rows above and below
differs() { shot && [ -s "$WORK/first.png" ] && ! cmp -s "$WORK/first.png" "$WORK/shot.png"; }
check_full_screen() {
    check "its window is as large as the screen" measures 1000 700
    check "... in its corner" prints 'geometry 1000x700\+0\+0' xwininfo -id "$window"
    shot && mv "$WORK/shot.png" "$WORK/first.png"
    check "the picture changes" await differs
    check "the aspect is kept, bars are black" is_black 1000x67+0+0
    check "below too" is_black 1000x67+0+633
    check "... and the picture is not" await is_bright
}
# grows TIMES [PID]: the share of its middle row that is copper, until the film comes, which begins with black. PID is held
# while we look: so how often we can does not depend on what else the machine does
grows() {
    local before=0 now=0 steps=0 end=$((SECONDS + PATIENCE))
    while [ $SECONDS -lt $end ]; do
        [ $# -lt 2 ] || kill -STOP "$2"
        shot -crop 1000x1+0+350 && now=$(measured 'int(1000*mean.r)')
        [ $# -lt 2 ] || kill -CONT "$2"
        [ "$now" -gt "$before" ] && steps=$((steps + 1))
        [ "$now" -lt "$before" ] && break
        before=$now
        sleep 0.1
    done
    echo "    the bar was seen to grow $steps times, and to $before"
    [ $steps -ge "$1" ] && [ "$now" -lt "$before" ]
}

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

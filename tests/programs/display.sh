# Sourced by tests of programs in a window: starts a display in memory, and examines what it shows.
declare -F check >/dev/null || . "$(dirname "${BASH_SOURCE[0]}")/common.sh"
skip_unless Xvfb xdotool xwininfo import identify

start_display() { # start_display WIDTHxHEIGHT[xDEPTH] OPTION...: sets DISPLAY
    # (without -noreset the server resets when its last client ends, and refuses the next one for a moment)
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

# A window that is mapped while its manager starts may stay unmapped, and GLFW 3.3 would wait for it forever
has_window_manager() { xprop -root _NET_SUPPORTING_WM_CHECK | grep -q 'window id'; }
start_window_manager() {
    skip_unless openbox xprop
    openbox >/dev/null 2>&1 &
    PIDS+=($!)
    await has_window_manager || exit 1
}

# --- Windows and screenshots ---
WINDOW="^$FILM\$" # its title
seen() { window=$(xdotool search --onlyvisible --name "$WINDOW" 2>/dev/null | tail -n 1) && [ -n "$window" ]; }
titled() { xdotool getwindowname "$window" 2>/dev/null | grep -qE -- "$1"; }
focused() { [ "$(xdotool getwindowfocus -f)" = "$window" ]; }
measures() { # measures WIDTH HEIGHT: succeeds if the window has this size
    local info
    info=$(xwininfo -id "$window") && grep -q "Width: $1\$" <<<"$info" && grep -q "Height: $2\$" <<<"$info"
}
shot() { import -window "$window" "$@" -quality 0 "$WORK/shot.png"; } # hardly compressed, since it is read once
measured() { identify -format "%[fx:$1]" "$WORK/shot.png"; }
is_bright() { shot && less 0.1 "$(measured mean)"; } 2>/dev/null
is_black() { shot -crop "$1" && [ "$(measured maxima)" = 0 ]; } # is_black WIDTHxHEIGHT+X+Y

begin() { # begin PROGRAM OPTION...: starts the program, waits for its window, and sets pid and window
    await eval '! seen' # an earlier program's window disappears a moment after its end
    in_background "$@"
    await eval "seen || gone $pid"
    seen
}

# drawn: waits until the time in odraz-debug's title has changed twice. By then the picture shows every request
drawn() {
    local before i
    for i in 1 2; do
        before=$(title)
        await eval '[ "$(title)" != "$before" ]' || return 1
    done
}
title() { xdotool getwindowname "$window"; }

# play OPTION...: starts the film by load(), and waits for a picture, which comes after unpacking and solving the hall
play() { load "$@" && await eval "is_bright || gone $pid" && is_bright; }
# comes CONDITION: waits until the condition holds; fails if the program ends first
comes() { await eval "$* || gone $pid" && ! gone "$pid"; }
press() { xdotool key --window "$window" "$@"; }
# on_key KEYS WHAT COMMAND...: presses the keys; then the command must succeed
on_key() {
    xdotool key $1
    check "$2" await "${@:3}"
}
leaves() { "$@" >/dev/null 2>&1; ended $pid; } # leaves COMMAND...: the command ends the film, with status 0
escapes() { xdotool key Escape; ended $pid && [ ! -s "$WORK/err" ]; } # ESC ends it with status 0, silently
managed() { wmctrl -l | grep -q ' odraz$'; }

# Checks the film on a full screen of 1000x700, which is taller than 16:9: 68 or 69 rows above and below are black
differs() { shot && [ -s "$WORK/first.png" ] && ! cmp -s "$WORK/first.png" "$WORK/shot.png"; }
check_full_screen() {
    check "its window is as large as the screen" measures 1000 700
    check "... in its corner" prints 'geometry 1000x700\+0\+0' xwininfo -id "$window"
    shot && mv "$WORK/shot.png" "$WORK/first.png"
    check "the picture changes" await differs
    check "the aspect ratio is kept, and the bars are black" is_black 1000x67+0+0
    check "... below, too" is_black 1000x67+0+633
    check "... and the picture is not black" await is_bright
}
# grows [PID]: waits until the loading bar, the red in the middle row, has grown three times, or until the film begins,
# which is black at first. PID is stopped for each screenshot, so that no step is missed on a busy machine
grows() {
    local before=0 now=0 steps=0 end=$((SECONDS + PATIENCE))
    while [ $SECONDS -lt $end ]; do
        [ $# -lt 1 ] || kill -STOP "$1"
        shot -crop 1000x1+0+350 && now=$(measured 'int(1000*mean.r)')
        [ $# -lt 1 ] || kill -CONT "$1"
        [ "$now" -gt "$before" ] && steps=$((steps + 1))
        [ $steps = 3 ] || [ "$now" -lt "$before" ] && break
        before=$now
        sleep 0.1
    done
    echo "    the bar grew $steps times, up to $before"
    [ $steps -ge 1 ]
}

# Sourced by sections that show the film: a display in memory, until the section ends.

# display WIDTHxHEIGHT: sets DISPLAY, and XVFB to its process
display() {
    Xvfb -noreset -displayfd 5 -screen 0 "$1x24" -nolisten tcp 5>"$WORK/display" >/dev/null 2>&1 &
    XVFB=$!
    trap "kill $XVFB" EXIT
    for _ in $(seq 100); do [ -s "$WORK/display" ] && break; sleep 0.1; done
    [ -s "$WORK/display" ] || { echo "${0##*/}: Xvfb does not start" >&2; return 1; }
    DISPLAY=:$(cat "$WORK/display")
    export DISPLAY
}

# The film's music on Windows, played by Wine to a PulseAudio server: by waveOut, which reports a position.
. "$(dirname "$0")/wine.sh"
. "$(dirname "$0")/../recorded.sh"
can_serve || { echo "SKIPPED: PulseAudio is not installed"; exit 77; }
film=$BUILD/odraz-safe.exe
start_display 640x400
play() { timeout "$PATIENCE" "$wine" "$film" --window --size 160x90 "$@" >"$WORK/out" 2>"$WORK/err"; }
"$BUILD/odraz-safe" --wav - --to 8 | tail -c +45 >"$WORK/film"

check "a server starts" serve
check "plays what --wav writes, to the last bit, from its first hundredth of a second on" into_server 6 4 0 480
check "plays from the middle, and prints how far the sound was off" play --from 50 --to 53 --stats
check "... by a time that is printed" grep -qE '^sound off by ms: median below [0-9]+, p95 below [0-9]+' "$WORK/out"
grep '^sound off' "$WORK/out"
record "$WORK/silence"
check "--mute plays" play --mute --to 1
kill $recorder
check "... in silence" eval '! is_loud "$WORK/silence"'
{ kill "$server"; wait "$server"; } 2>/dev/null
check "plays without a device" play --to 1
finish

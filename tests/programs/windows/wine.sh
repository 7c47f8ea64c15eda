# Sourced by tests of programs for Windows, which Wine runs: "$wine" PROGRAM OPTION...
. "$(dirname "$0")/../common.sh"
. "$SOURCE/tools/build/wine.sh"
have_wine || { echo "SKIPPED: Wine (wine64) is not installed"; exit 77; }
unset DISPLAY

# What it has started ends with the test, too: devices of its own would stay, and keep the processor busy
end_wine() {
    local status=$?
    "$wine_server" -k
    return $status
}
trap 'end_wine; leave' EXIT
start_wine || exit 1
PIDS+=($WINE_PID)

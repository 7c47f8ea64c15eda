# Sourced by tests of programs for Windows. $wine PROGRAM OPTION... runs one.
. "$(dirname "$0")/../common.sh"
. "$SOURCE/tools/build/wine.sh"
have_wine || { echo "SKIPPED: Wine (wine64) is not installed"; exit 77; }
unset DISPLAY

# Processes that Wine started end with the test: otherwise its device processes would keep the processor busy
end_wine() {
    local status=$?
    "$wine_server" -k
    return $status
}
trap 'end_wine; leave' EXIT
start_wine || exit 1
PIDS+=($WINE_PID)

# Sourced by tests of programs for Windows. $wine PROGRAM OPTION... runs one.
. "$(dirname "$0")/../display.sh"
. "$SOURCE/tools/build/wine.sh"
have_wine || { echo "SKIPPED: Wine (wine64) is not installed"; exit 77; }
unset DISPLAY

# Ends the processes that Wine started: otherwise its device processes would keep the processor busy
end_wine() {
    local status=$?
    "$wine_server" -k
    return $status
}
trap 'end_wine; leave' EXIT
start_wine || exit 1
PIDS+=($WINE_PID)

# boxed STATUS NAME COMMAND...: succeeds if a message box of that name opens, Return closes it, and the command ends
# with STATUS
boxed() {
    local status=$1 name=$2
    shift 2
    "$@" &
    pid=$!
    PIDS+=($pid)
    await eval "xdotool search --onlyvisible '$name' >/dev/null 2>&1" && await returned "$name"
    ended $pid
    [ $? = "$status" ]
}
returned() { xdotool search --onlyvisible "$1" windowfocus key Return 2>/dev/null; sleep 0.1; gone $pid; }
without_stderr() { exec "$@" 2>&-; }

# Sourced by the end-to-end tests: bash tests/programs/NAME.sh BUILD
BUILD=$(cd "$1" && pwd)
SOURCE=$(cd "$(dirname "$0")/../.." && pwd)
WORK=$(mktemp -d)
trap 'stop_all; rm -rf "$WORK"' EXIT
PIDS=()
FAILED=0

stop_all() { for pid in "${PIDS[@]}"; do kill "$pid" 2>/dev/null; done; }

check() { # check WHAT COMMAND...: the command must succeed
    local what=$1
    shift
    if "$@"; then echo "ok: $what"; else echo "FAILED: $what" >&2; FAILED=1; fi
}

skip_unless() { # programs that a test cannot do without
    local program
    for program in "$@"; do command -v "$program" >/dev/null || { echo "SKIPPED: $program is not installed"; exit 77; }; done
}

# refuses STATUS TEXT COMMAND...: exits with the status and says one line with the text on stderr, nothing on stdout
refuses() {
    local status=$1 text=$2 got
    shift 2
    timeout 60 "$@" >"$WORK/out" 2>"$WORK/err"
    got=$?
    [ "$got" = "$status" ] && [ "$(wc -l <"$WORK/err")" = 1 ] && grep -qF -- "$text" "$WORK/err" && [ ! -s "$WORK/out" ] && return 0
    echo "exit $got, wanted $status; stderr: $(head -c 300 "$WORK/err")" >&2
    return 1
}

less() { awk "BEGIN { exit !($1 < $2) }"; } # less A B: numbers

finish() { exit $FAILED; }

# Sourced by the end-to-end tests: bash tests/programs/NAME.sh BUILD [ARGUMENT...]
#
# A test fails for a wrong result, not for a busy machine: it waits for a condition, not for a fixed time. After
# PATIENCE seconds it assumes that the program hangs, and fails. ctest's time-out (tests/CMakeLists.txt) is longer.
unset CDPATH
BUILD=$(cd "$1" && pwd) || exit 1
SOURCE=$(cd "$(dirname "$0")/../.." && pwd)
[ -d "$SOURCE/intro" ] || SOURCE=$(cd "$(dirname "$0")/../../.." && pwd) # from long/, windows/
. "$SOURCE/intro/film.conf"
PATIENCE=${PATIENCE:-1200}
WORK=$(mktemp -d)
PIDS=()
CHECKS=0 FAILED=0 FINISHED=

leave() {
    local status=$? pid tries=0
    for pid in "${PIDS[@]}"; do kill "$pid" && kill -CONT "$pid"; done 2>/dev/null
    # The processes may write into the folder until they end. A folder that cannot be removed does not fail the test
    for pid in "${PIDS[@]}"; do PATIENCE=10 await gone "$pid" || kill -KILL "$pid"; done 2>/dev/null
    until rm -rf "$WORK" 2>/dev/null || [ $((++tries)) = 50 ]; do sleep 0.1; done
    [ -n "$FINISHED" ] || [ $status = 77 ] || { echo "FAILED: the test ended too early, with status $status" >&2; exit 1; }
}
trap leave EXIT

check() { # check WHAT COMMAND...: the command must succeed
    local what=$1 began=${EPOCHREALTIME/[.,]/} took=
    shift
    CHECKS=$((CHECKS + 1))
    "$@" && set -- ok || set -- FAILED
    began=$(((${EPOCHREALTIME/[.,]/} - began) / 1000000))
    [ $began -ge 2 ] && took="   ($began s)"
    if [ "$1" = ok ]; then echo "ok: $what$took"; else echo "FAILED: $what$took" >&2; FAILED=1; fi
}

finish() {
    FINISHED=1
    [ $CHECKS -gt 0 ] || { echo "FAILED: nothing was checked" >&2; FAILED=1; }
    exit $FAILED
}

# skip_unless PROGRAM...: where one of them is missing, skips the rest of the test, which fails if a check has failed
skip_unless() {
    local program
    for program in "$@"; do
        command -v "$program" >/dev/null && continue
        [ "$FAILED" = 0 ] || finish
        echo "SKIPPED: $program is not installed"
        exit 77
    done
}
# lacking LIBRARY: prints a folder for LD_LIBRARY_PATH in which the library is a text file, so that it does not load
lacking() {
    mkdir -p "$WORK/$1.d"
    echo "not a library" >"$WORK/$1.d/$1"
    echo "$WORK/$1.d"
}
# copy_sources FOLDER: copies the files that git tracks, except those that were removed without a commit
copy_sources() {
    mkdir -p "$1"
    (cd "$SOURCE" && git ls-files -z | xargs -0 cp --parents -t "$1") 2>"$WORK/copied" || true
}
# flip FILE OFFSET [BITS]: inverts the bits of one byte that are set in the mask BITS, by default all eight
flip() {
    printf "\\x$(printf %02x $(($(od -An -tu1 -j "$2" -N 1 "$1") ^ ${3-255})))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
# "${MDWE[@]}" COMMAND...: runs the command where written memory may not be executed (PR_SET_MDWE). Exits with status 77
# before Linux 6.3
MDWE=(perl -e 'syscall(157, 65, 1, 0, 0, 0) == 0 or exit 77; exec { $ARGV[0] } @ARGV')
has_mdwe() {
    "${MDWE[@]}" true || { echo "not checked: this kernel cannot forbid the execution of written memory"; false; }
}
needs_built() { # needs_built PROGRAM...
    local program
    for program in "$@"; do [ -x "$BUILD/$program" ] || { echo "SKIPPED: $program is not built"; exit 77; }; done
}

# --- Outputs of programs ---

# refuses STATUS TEXT COMMAND...: succeeds if the command exits with STATUS, and prints one line with TEXT on stderr and
# nothing on stdout
refuses() {
    local status=$1 text=$2 got
    shift 2
    timeout "$PATIENCE" "$@" >"$WORK/out" 2>"$WORK/err"
    got=$?
    [ "$got" = "$status" ] && [ "$(wc -l <"$WORK/err")" = 1 ] && grep -qF -- "$text" "$WORK/err" && [ ! -s "$WORK/out" ] && return 0
    echo "exit $got, wanted $status; stderr: $(head -c 300 "$WORK/err")" >&2
    return 1
}
# transcript COMMAND...: prints the command's outputs, stdout and stderr, and its exit status
transcript() {
    {
        timeout "$PATIENCE" "$@" 2>&1
        echo "status $?"
    } 2>/dev/null # hides the shell's reports of signals
}
# prints PATTERN COMMAND...: succeeds if the command does and a line of its output matches
prints() {
    local pattern=$1
    shift
    "$@" >"$WORK/printed" && grep -qE -- "$pattern" "$WORK/printed" && return 0
    echo "printed: $(head -c 300 "$WORK/printed")" >&2
    return 1
}
# exits STATUS TEXT COMMAND...: succeeds if the command exits with STATUS, and prints just TEXT on stdout, nothing on
# stderr
exits() {
    local status=$1 text=$2 got
    shift 2
    got=$("$@" 2>"$WORK/err")
    [ $? = "$status" ] && [ "$got" = "$text" ] && [ ! -s "$WORK/err" ]
}
# lacks PATTERN FILE: succeeds if the file is not empty and none of its lines matches
lacks() {
    [ -s "$2" ] || { echo "$2 is empty" >&2; return 1; }
    grep -aE -m 3 -- "$1" "$2" >&2
    [ $? = 1 ] # 2 is an error
}

# --- Numbers ---

# less A B: succeeds if A < B; fails if one of them is not a number, such as nan or nothing
less() {
    local n
    for n in "${1-}" "${2-}"; do
        [[ $n =~ ^-?[0-9]+(\.[0-9]*)?(e[-+]?[0-9]+)?$ ]] || { echo "'$1' < '$2'? '$n' is not a number" >&2; return 1; }
    done
    awk "BEGIN { exit !(($1) < ($2)) }"
}
# table FILE ACTION CONDITION: awk runs ACTION on every row of a CSV file. Succeeds if CONDITION holds at the end, the
# file has a row after its header, and all numbers are finite
table() {
    lacks '(^|,)[-+]?(nan|inf)' "$1" && awk -F, "NR > 1 { ++lines; $2 } END { exit !(lines > 0 && ($3)) }" "$1"
}

# --- Waiting ---

# await COMMAND...: repeats the command until it succeeds
await() {
    local end=$((SECONDS + PATIENCE))
    until "$@"; do
        [ $SECONDS -lt $end ] || { echo "waited $PATIENCE s without success for: $*" >&2; return 1; }
        sleep ${PAUSE:-0.1}
    done
}
gone() { ! kill -0 "$1" 2>/dev/null; }
# in_background COMMAND...: starts the command and sets pid. Its outputs go into the files out and err. They are emptied
# first, so that no test finds a line of an earlier program
in_background() {
    : >"$WORK/out"
    : >"$WORK/err"
    "$@" >"$WORK/out" 2>"$WORK/err" &
    pid=$!
    PIDS+=($pid)
}
# ended PID: waits for a child of this shell, and returns its exit status
ended() {
    await gone "$1" || kill -KILL "$1"
    wait "$1"
}
# worked PID N: waits until the process has used N hundredths of a second more of processor time; fails if it ends first
worked() {
    local until=$(($(ticks "$1") + $2))
    PAUSE=0.02 await eval "[ \"\$(ticks $1)\" -ge $until ] || gone $1"
    ! gone "$1"
}
ticks() {
    local stat
    { read -r stat <"/proc/$1/stat"; } 2>/dev/null || { echo 0; return; }
    set -- ${stat##*) } # the program's name, in brackets, may hold blanks
    echo $((${12} + ${13}))
}

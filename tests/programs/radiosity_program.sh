# Sourced by tests of the radiosity program: sets radiosity, and enters WORK.
. "$(dirname "$0")/common.sh"
radiosity=$BUILD/radiosity
needs_built radiosity
cd "$WORK" || exit 1
# stopped_at PATTERN FILE: Ctrl-C when the file of what runs behind has such a line; its exit status
stopped_at() {
    await grep -qE "$1" "$2"
    kill -INT $pid
    ended $pid
}
# solved NAME MODEL OPTION...: NAME.rad and NAME.csv; what it printed is in NAME.out and NAME.err
solved() {
    local name=$1
    shift
    rm -f "$name".{rad,csv}
    "$radiosity" solve "$@" -o "$name.rad" >"$name.out" 2>"$name.err" && grep -q '^processor seconds' "$name.out" &&
        "$radiosity" export "$name.rad" --csv "$name.csv"
}

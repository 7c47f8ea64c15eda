# Sourced by tests of the radiosity program: sets radiosity and changes to the folder WORK.
. "$(dirname "$0")/common.sh"
radiosity=$BUILD/radiosity
needs_built radiosity
cd "$WORK" || exit 1
# stopped_at PATTERN FILE: sends Ctrl-C to process pid when the file has a line that matches; returns the exit status
stopped_at() {
    await grep -qE "$1" "$2"
    kill -INT $pid
    ended $pid
}
# solved NAME MODEL OPTION...: solves the model: NAME.rad, NAME.csv; the outputs go into NAME.out and NAME.err
solved() {
    local name=$1
    shift
    rm -f "$name".{rad,csv}
    "$radiosity" solve "$@" -o "$name.rad" >"$name.out" 2>"$name.err" && grep -q '^processor seconds' "$name.out" &&
        "$radiosity" export "$name.rad" --csv "$name.csv"
}

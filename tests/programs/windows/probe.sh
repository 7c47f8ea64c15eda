# Checks the film's host and start on Windows, from inside a program that is made like the film (probe/), packed and not
# packed.
. "$(dirname "$0")/wine.sh"
start_display 640x400
needs_built tests/probe.exe tests/probe-safe.exe

# probe PART LEAST ARGUMENT...: prints its lines; at least LEAST begin with ok, and none with anything else
probe() {
    local part=$1 least=$2 status
    shift 2
    timeout "$PATIENCE" "$wine" "$program" "$part" "$@" >"$WORK/printed" 2>"$WORK/err" </dev/null
    status=$?
    grep -v '^ok: ' "$WORK/printed" | sed 's/^/    /' >&2
    head -c 300 "$WORK/err" >&2
    [ $status = 0 ] && [ ! -s "$WORK/err" ] && [ "$(grep -c '^ok: ' "$WORK/printed")" -ge "$least" ]
}
whole() { # what `names` leaves in its folder
    [ "$(cat "$folder/a")" = three ] && [ "$(cat "$folder/b")" = ours ] && [ "$(cat "$folder"/b.*.part)" = "somebody's" ] &&
        [ "$(ls -A "$folder" | wc -l)" = 4 ] && [ ! -s "$folder/held" ]
}
for program in "$BUILD/tests/probe-safe.exe" "$BUILD/tests/probe.exe"; do
    name=$(basename "$program")
    folder=$WORK/$name.d
    mkdir "$folder"
    check "$name: floats are rounded as on Linux, stacks are there" probe floats 35
    check "$name: calls pass all their arguments to Windows" probe passing 14
    check "$name: arguments are split as Windows does" probe arguments 7 "$(printf '%031000d' 0)"
    check "$name: files are whole or absent" probe names 18 "$folder"
    check "... nothing else is left there" whole
    check "$name: clocks" probe times 13
    check "$name: our functions keep the registers of Windows, which calls them" probe shown 28
done
check "the packed probe's early function is called before all is decoded" grep -q '^ok: the stub has called what is early' "$WORK/printed"
finish

# On Windows the film asks for five of the system's libraries and no others.
. "$(dirname "$0")/wine.sh"
start_display 640x400

# loaded PROGRAM OPTION...: runs the program, and writes the libraries that it asks for into the file `asked`
loaded() {
    WINEDEBUG=-all,+relay timeout "$PATIENCE" "$wine" "$@" </dev/null >/dev/null 2>"$WORK/trace" || return
    # The program's own calls return to its addresses, below 16 MB
    grep -aoE 'Call KERNEL32\.(LoadLibrary|LdrLoadDll)[A-Za-z]*\([0-9a-f]+ L?"[^"]*".* ret=00[0-9a-f]{6}$' "$WORK/trace" | sed 's/^[^"]*"//; s/".*//; s/\.dll$//' | tr A-Z a-z | sort -u >"$WORK/asked"
    [ -s "$WORK/asked" ]
}
small=(--size 64x36 --quality draft)
asks() { # asks WHAT WANTED OPTION...: checks that the film asks for the libraries WANTED
    local what=$1 wanted=$2
    shift 2
    check "$what" loaded "$BUILD/odraz-safe.exe" "$@"
    check "... asks for $wanted" test "$(tr '\n' ' ' <"$WORK/asked")" = "$wanted "
}
asks "frames without the hall" "kernel32" --dump - --from 20 --to 20.04 "${small[@]}"
asks "music" "kernel32" --wav - --to 0.1
asks "help" "kernel32" --help
asks "frames of the hall" "gdi32 kernel32 opengl32 user32" --dump - --from 100 --to 100.04 "${small[@]}"
asks "the film" "gdi32 kernel32 opengl32 user32 winmm" --window --size 64x36 --from 163.9
finish

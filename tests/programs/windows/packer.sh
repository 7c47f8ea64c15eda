# The packer's example for Windows, run by Wine.
. "$(dirname "$0")/wine.sh"
pack=$BUILD/pack
check "the example is built" bash "$SOURCE/packer/example/build.sh" "$pack" "$WORK" --pe
exe=$WORK/hello.exe
check "it runs" exits 7 "hello, 42" "$wine" "$exe"
check "by another path" exits 7 "hello, 42" bash -c "cd '$WORK' && exec '$wine' ./hello.exe"
check "--test reports that it is whole" prints ': whole; ' "$pack" --test "$exe"
check "-d unpacks it" "$pack" -d "$exe" -o "$WORK/plain.exe"
check "... and that runs" exits 7 "hello, 42" "$wine" "$WORK/plain.exe"
check "... as --plain makes it" "$pack" "$WORK/hello_windows.elf" -o "$WORK/again.exe" --pe --plain
check "... with the same bytes" cmp "$WORK/plain.exe" "$WORK/again.exe"

# Damage. (The film has the same checking code)
broken=$WORK/broken.exe
total=$(stat -c %s "$exe")
checked=$((512 + 264 + 300)) # after headers, imports, and the code that checks and reports
is_refused() { refuses 1 "damaged: copy it again" "$wine" "$broken" && refuses 2 "$broken: " "$pack" --test "$broken" && refuses 2 "$broken: " "$pack" -d "$broken" -o "$WORK/x"; }
flipped() {
    local at
    [ "$total" -gt 3000 ] || return 1
    for at in $(seq $checked 97 $((total - 1))) $((total - 1)); do
        cp "$exe" "$broken" && flip "$broken" "$at" $((1 << at % 8)) && is_refused || { echo "at $at"; return 1; }
    done
}
check "a flipped bit anywhere is refused" flipped
{ cat "$exe"; echo "more bytes"; } >"$broken"
check "bytes after its end do not matter" exits 7 "hello, 42" "$wine" "$broken"

# Without standard error a box shows the message
start_display 640x480
cp "$exe" "$broken" && flip "$broken" $((total - 1)) 1
check "a box opens, which Return closes, with status 1" boxed 1 'damaged: copy it again' without_stderr "$wine" "$broken"
finish

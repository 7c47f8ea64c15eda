# The packed film: its size, its name, and that it draws and opens as the film does that is not packed.
. "$(dirname "$0")/display.sh"
packed=$BUILD/$FILM safe=$BUILD/$FILM-safe
for file in "$packed" "$packed.exe"; do
    check "${file##*/} is within its budget" test "$(stat -c %s "$file")" -le "$FILM_BUDGET"
    check "... and whole" prints ': whole; ' "$BUILD/pack" --test "$file"
done
check "--version tells the film's name" prints "^$FILM $FILM_VERSION " "$packed" --version
check "... the same as $FILM-safe" test "$("$packed" --version)" = "$("$safe" --version)"
check "messages begin with its name" prints "^$FILM: unknown option '--nope'" bash -c '! "$0" --nope 2>&1' "$packed"

# Dumps of scenes without a hall need no OpenGL
small=(--size 64x36 --from 2 --to 2.2 --quality draft)
check "it dumps without OpenGL" env LIBGL_DRIVERS_PATH=/none "$packed" --dump "$WORK/packed" "${small[@]}"
check "... what $FILM-safe dumps" "$safe" --dump "$WORK/safe" "${small[@]}"
check "... the same" diff -r "$WORK/safe" "$WORK/packed"

start_display 640x400
begin "$packed" --window --mute
check "it opens a window with its name" seen
finish

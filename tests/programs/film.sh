# The packed film: its size, and one check of each kind. Other tests run all checks on the unpacked film, which is the
# same program and starts seconds sooner; tools/test --long runs them on the packed one.
. "$(dirname "$0")/common.sh"
unset DISPLAY WAYLAND_DISPLAY
packed=$BUILD/$FILM safe=$BUILD/$FILM-safe
for file in "$packed" "$packed.exe"; do
    check "${file##*/} is within its budget" test "$(stat -c %s "$file")" -le "$FILM_BUDGET"
    check "... and whole" prints ': whole; ' "$BUILD/pack" --test "$file"
done
check "--version prints the same as $FILM-safe" prints "^$("$safe" --version | sed 's/[.+]/\\&/g')\$" "$packed" --version
small=(--size 64x36 --from 2 --to 2.2 --quality draft)
check "it dumps with all descriptors closed, and without OpenGL" env LIBGL_DRIVERS_PATH=/none bash -c "exec '$packed' --dump '$WORK/frames' ${small[*]} <&- >&- 2>&-"
"$safe" --dump "$WORK/same" "${small[@]}"
check "... the same as $FILM-safe" diff -r "$WORK/same" "$WORK/frames"

check "without a display" refuses 1 "no X display" "$packed"
if [ "$FILM" = odraz ]; then # the hall
    odraz=$packed
    . "$(dirname "$0")/memory.sh"
fi

. "$(dirname "$0")/display.sh"
start_display 640x400
begin "$packed" --window --mute
check "it opens a window with its name" seen
finish

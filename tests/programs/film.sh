# The packed film: its size, and one check of each kind. Other tests run all checks on the unpacked film, which is the
# same program and starts seconds sooner; tools/test --long runs them on the packed one.
. "$(dirname "$0")/common.sh"
unset DISPLAY WAYLAND_DISPLAY
packed=$BUILD/$FILM safe=$BUILD/$FILM-safe
for file in "$packed" "$packed.exe"; do
    check "${file##*/} is within its budget" test "$(stat -c %s "$file")" -le "$FILM_BUDGET"
    check "... and whole" prints ': whole; ' "$BUILD/pack" --test "$file"
done
check "--version is that of $FILM-safe" prints "^$("$safe" --version | sed 's/[.+]/\\&/g')\$" "$packed" --version
check "it refuses an unknown option" refuses 2 "$FILM: unknown option '--nope'" "$packed" --nope
small=(--size 64x36 --from 2 --to 2.2 --quality draft)
check "--dump reports a full disk" refuses 1 "cannot write standard output: no space left" bash -c "exec '$packed' --dump - ${small[*]} >/dev/full"
check "it dumps with all descriptors closed, and without OpenGL" env LIBGL_DRIVERS_PATH=/none bash -c "exec '$packed' --dump '$WORK/frames' ${small[*]} <&- >&- 2>&-"
"$safe" --dump "$WORK/same" "${small[@]}"
check "... the same as $FILM-safe" diff -r "$WORK/same" "$WORK/frames"

check "without a display" refuses 1 "no X display" "$packed"
check "without libX11.so.6" refuses 1 "libX11.so.6 is missing" env LD_LIBRARY_PATH="$(lacking libX11.so.6)" "$packed"
check "without memory" refuses 1 "not enough memory" bash -c "ulimit -v 300000; exec '$packed' --dump - --size 7680x4320"
if [ "$FILM" = odraz ]; then # the hall
    check "without a driver, for the hall" refuses 1 "no headless OpenGL 3.3: install" env LIBGL_DRIVERS_PATH=/none "$packed" --dump - --from 100 --to 100.04
    odraz=$packed
    . "$(dirname "$0")/memory.sh" # what it takes with the hall
fi

. "$(dirname "$0")/display.sh"
start_display 640x400
begin "$packed" --window --mute
check "it opens a window with its name" seen
finish

# Asks the packed film one question of each kind that commandline.sh and machine.sh ask odraz-safe, which is the same
# program and need not unpack itself for seconds. tools/test --long asks the packed film all of them.
. "$(dirname "$0")/common.sh"
unset DISPLAY WAYLAND_DISPLAY
odraz=$BUILD/odraz safe=$BUILD/odraz-safe
check "--version is that of odraz-safe" prints "^$("$safe" --version | sed 's/[.+]/\\&/g')\$" "$odraz" --version
check "it refuses an unknown option" refuses 2 "unknown option '--nope'" "$odraz" --nope
small=(--size 64x36 --from 20 --to 20.2 --quality draft)
check "--dump reports a full disk" refuses 1 "cannot write standard output: no space left" bash -c "exec '$odraz' --dump - ${small[*]} >/dev/full"
check "it dumps with all descriptors closed" bash -c "exec '$odraz' --dump '$WORK/frames' ${small[*]} <&- >&- 2>&-"
"$safe" --dump "$WORK/same" "${small[@]}"
check "... the same as odraz-safe" diff -r "$WORK/same" "$WORK/frames"

check "without a display" refuses 1 "no X display" "$odraz"
check "without libX11.so.6" refuses 1 "libX11.so.6 is missing" env LD_LIBRARY_PATH="$(lacking libX11.so.6)" "$odraz"
check "without memory" refuses 1 "not enough memory" bash -c "ulimit -v 300000; exec '$odraz' --dump - --size 7680x4320"
check "without a driver, for the hall" refuses 1 "no headless OpenGL 3.3: install" env LIBGL_DRIVERS_PATH=/none "$odraz" --dump - --from 100 --to 100.04
. "$(dirname "$0")/memory.sh" # what it takes with the hall
finish

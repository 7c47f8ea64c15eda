# Where a machine lacks something, the film prints one line on standard error and exits with status 1.
#   machine.sh BUILD odraz|odraz-safe
. "$(dirname "$0")/common.sh"
unset DISPLAY WAYLAND_DISPLAY
odraz=$BUILD/${2:-odraz}
check "without a display" refuses 1 "no X display" "$odraz"
check "without libX11.so.6" refuses 1 "libX11.so.6 is missing" env LD_LIBRARY_PATH="$(lacking libX11.so.6)" "$odraz"
check "without threads" \
    refuses 1 "libpthread.so.0" env LD_LIBRARY_PATH="$(lacking libpthread.so.0)" "$odraz" --dump - --threads 2
check "without memory" refuses 1 "not enough memory" bash -c "ulimit -v 300000; exec '$odraz' --dump - --size 7680x4320"
check "without memory for OpenGL" \
    refuses 1 "not enough memory for OpenGL: raise ulimit -v" bash -c "ulimit -v 700000; exec '$BUILD/odraz-safe' --dump - --size 1x1 --from 120 --to 120.04"
check "an empty interval of the hall needs no OpenGL" \
    env LD_LIBRARY_PATH="$(lacking libEGL.so.1)" "$odraz" --dump - --from 100 --to 100
check "without headless OpenGL, for the hall" \
    refuses 1 "no headless OpenGL 3.3: install" env LD_LIBRARY_PATH="$(lacking libEGL.so.1)" "$odraz" --dump - --from 100 --to 100.04
check "without a driver: one line, though Mesa prints more" \
    refuses 1 "no headless OpenGL 3.3: install" env LIBGL_DRIVERS_PATH=/none "$odraz" --dump - --from 100 --to 100.04
if has_mdwe; then
    check "where written memory may not be executed, odraz-safe draws scenes without the hall" \
        "${MDWE[@]}" "$BUILD/odraz-safe" --dump "$WORK/frames" --from 20 --to 20.04 --size 64x36
    check "... and reports why it cannot draw the hall" \
        refuses 1 "SELinux forbids code that OpenGL generates: allow it" "${MDWE[@]}" "$BUILD/odraz-safe" --dump - --from 100 --to 100.04
fi

# dumped FILE COMMAND...: succeeds if the command writes a picture of 64x36, which goes into the file
dumped() {
    local to=$1
    shift
    "$@" >"$to" && [ "$(stat -c %s "$to")" = $((64 * 36 * 3 + 13)) ]
}
hall=(--dump - --from 120 --to 120.04 --size 64x36)
check "it draws the hall" dumped "$WORK/with.ppm" "$odraz" "${hall[@]}"
check "where OpenGL has no integers" refuses 1 "cannot light the hall: OpenGL 3.3 cannot draw integers" \
    env MESA_EXTENSION_OVERRIDE=-GL_EXT_texture_integer "$odraz" "${hall[@]}"

. "$(dirname "$0")/memory.sh"

plain=(--dump - --from 20 --to 20.04 --size 64x36)
check "it needs none of the window's libraries to dump" \
    dumped "$WORK/plain.ppm" env LD_LIBRARY_PATH="$(lacking libX11.so.6):$(lacking libGL.so.1)" "$odraz" "${plain[@]}"
check "without address randomisation" dumped "$WORK/still.ppm" setarch -R "$odraz" "${plain[@]}"
check "... the same" cmp "$WORK/plain.ppm" "$WORK/still.ppm"
if command -v qemu-x86_64 >/dev/null; then
    check "on a processor of 2008" refuses 1 "AVX2" qemu-x86_64 -cpu Nehalem "$odraz" --version
    qemu-x86_64 -cpu Haswell "$odraz" --version >"$WORK/haswell" 2>"$WORK/err" # qemu prints which features it cannot emulate
    check "on a processor of 2013" grep -q ^odraz "$WORK/haswell"
else
    echo "skipped: qemu-x86_64 is not installed"
fi
finish

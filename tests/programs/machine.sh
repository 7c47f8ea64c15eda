# Machines that lack something: one line on standard error, exit 1.
. "$(dirname "$0")/common.sh"
unset DISPLAY WAYLAND_DISPLAY
for odraz in "$BUILD/odraz" "$BUILD/odraz-safe"; do
    name=${odraz##*/}
    check "$name without a display" refuses 1 "no X display" "$odraz"
    # A library that is no library stands for one that is missing
    for missing in libX11.so.6 libGL.so.1; do
        mkdir -p "$WORK/$missing.d"
        echo "not a library" >"$WORK/$missing.d/$missing"
        check "$name without $missing" refuses 1 "$missing is missing" env LD_LIBRARY_PATH="$WORK/$missing.d" "$odraz"
    done
    mkdir -p "$WORK/threads"
    echo "not a library" >"$WORK/threads/libpthread.so.0"
    check "$name without threads" refuses 1 "libpthread.so.0" env LD_LIBRARY_PATH="$WORK/threads" "$odraz" --dump - --threads 2
    check "$name without memory" refuses 1 "not enough memory" bash -c "ulimit -v 300000; exec '$odraz' --dump - --size 7680x4320"
    mkdir -p "$WORK/egl"
    echo "not a library" >"$WORK/egl/libEGL.so.1"
    check "$name without headless OpenGL, for the hall" refuses 1 "no headless OpenGL 3.3: install" env LD_LIBRARY_PATH="$WORK/egl" "$odraz" --dump - --from 100 --to 100.04
    check "$name with an OpenGL that is too old" refuses 1 "no headless OpenGL 3.3: install" env MESA_GL_VERSION_OVERRIDE=2.1 "$odraz" --dump - --from 100 --to 100.04
    check "$name without reversed depth draws the hall" bash -c "
        '$odraz' --dump - --from 120 --to 120.04 --size 64x36 >'$WORK/with.ppm' &&
        MESA_EXTENSION_OVERRIDE=-GL_ARB_clip_control '$odraz' --dump - --from 120 --to 120.04 --size 64x36 >'$WORK/without.ppm' &&
        '$BUILD/compare' '$WORK/with.ppm' '$WORK/without.ppm' --max 2 >/dev/null"
    check "$name solves the hall within 512 MB" bash -c "'$odraz' --dump - --from 100 --to 100.04 --size 1280x720 >/dev/null & pid=\$!; most=0
        while now=\$(awk '/VmHWM/ { print \$2 }' /proc/\$pid/status 2>/dev/null) && [ -n \"\$now\" ]; do most=\$now; sleep 0.05; done
        echo \"    \$((most / 1024)) MB resident\"; [ \$most -gt 1000 ] && [ \$most -lt 524288 ]"
    check "$name needs none of the window's libraries to dump" bash -c "LD_LIBRARY_PATH='$WORK/libX11.so.6.d:$WORK/libGL.so.1.d' '$odraz' --dump - --from 20 --to 20.04 --size 64x36 | cksum >'$WORK/$name.sum'"
    check "$name without address randomisation" bash -c "setarch -R '$odraz' --dump - --from 20 --to 20.04 --size 64x36 | cksum | cmp - '$WORK/$name.sum'"
    if command -v qemu-x86_64 >/dev/null; then
        check "$name on a processor of 2008" refuses 1 "AVX2" qemu-x86_64 -cpu Nehalem "$odraz" --version
        check "$name on a processor of 2013" bash -c "qemu-x86_64 -cpu Haswell '$odraz' --version 2>/dev/null | grep -q ^odraz"
    else
        echo "skipped: qemu-x86_64 is not installed"
    fi
done
finish

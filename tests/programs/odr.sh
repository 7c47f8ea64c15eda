# One name, one definition, as the compiler sees it: every object of tools, tests and the debug program holds the types
# that it uses (-flto), and these are compared over all programs at once. Nothing is compiled for it.
. "$(dirname "$0")/common.sh"
skip_unless ninja
[ -e "$BUILD/build.ninja" ] || { echo "SKIPPED: not built by ninja"; exit 77; }

# The live film defines the engine again, Windows and the page the host: chosen by file, never linked together. The
# page's objects are WebAssembly
ninja -C "$BUILD" -t inputs all | grep '\.o$' | grep -vE '/live\.dir/|/windows/|host/web/|^generated/' >"$WORK/objects"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$BUILD/CMakeCache.txt")
# types OBJECT...: compares them. Programs have a main() each: -z muldefs
types() {
    (cd "$BUILD" && "$compiler" -r -nostdlib -flto -flinker-output=rel -Wodr -Werror=odr -Wno-lto-type-mismatch \
        -Wl,-z,muldefs -o "$WORK/types.o" "$@") >"$WORK/printed" 2>&1
    local status=$?
    cat "$WORK/printed" >&2
    return $status
}
check "every type is one, over $(wc -l <"$WORK/objects") objects" types @"$WORK/objects"

# A second definition, linked into a program that has the first, is found
echo 'namespace odraz { struct Arena { int size; }; int sizeOf(const Arena &a) { return a.size; } }' >"$WORK/twin.cpp"
"$compiler" -flto -c "$WORK/twin.cpp" -o "$WORK/twin.o"
grep /base/ "$WORK/objects" >"$WORK/base"
found() {
    ! types "$WORK/twin.o" @"$WORK/base" 2>/dev/null && grep -q 'struct Arena.*One Definition' "$WORK/printed"
}
check "... and a second Arena would be found" found
finish

# One name, one definition. Every object of tools, tests and the debug program contains the types that it uses (-flto);
# here the compiler compares them over all programs at once. Nothing is compiled again.
. "$(dirname "$0")/common.sh"
skip_unless ninja
[ -e "$BUILD/build.ninja" ] || { echo "SKIPPED: not built by ninja"; exit 77; }

# Left out are second definitions that are never linked with the first: the engine of the live film, the host of Windows
# and of the page (whose objects are WebAssembly)
ninja -C "$BUILD" -t inputs all | grep '\.o$' | grep -vE '/live\.dir/|/windows/|host/web/|^generated/' >"$WORK/objects"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$BUILD/CMakeCache.txt")
# types OBJECT...: compares the types of the objects. -z muldefs, since each program has a main()
types() {
    (cd "$BUILD" && "$compiler" -r -nostdlib -flto -flinker-output=rel -Wodr -Werror=odr -Wno-lto-type-mismatch \
        -Wl,-z,muldefs -o "$WORK/types.o" "$@") >"$WORK/printed" 2>&1
    local status=$?
    cat "$WORK/printed" >&2
    return $status
}
check "no type has two definitions in $(wc -l <"$WORK/objects") objects" types @"$WORK/objects"

# A planted second definition must be found
echo 'namespace odraz { struct Arena { int size; }; int sizeOf(const Arena &a) { return a.size; } }' >"$WORK/twin.cpp"
"$compiler" -flto -c "$WORK/twin.cpp" -o "$WORK/twin.o"
grep /base/ "$WORK/objects" >"$WORK/base"
found() {
    ! types "$WORK/twin.o" @"$WORK/base" 2>/dev/null && grep -q 'struct Arena.*One Definition' "$WORK/printed"
}
check "... and a second Arena would be found" found
finish

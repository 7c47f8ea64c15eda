# What the shipped files are made of.
. "$(dirname "$0")/common.sh"
skip_unless readelf objdump
budget() { [ "$(stat -c %s "$BUILD/odraz")" -le 65536 ]; }
check "odraz is within its budget" budget

for name in odraz odraz-safe; do
    segments=$(readelf -lW "$BUILD/$name")
    check "$name is a fixed-base executable" grep -q "EXEC (Executable" <<<"$segments"
    check "$name has no segment that is writable and executable" bash -c "! grep -E 'LOAD|GNU_STACK' <<<'$segments' | grep -q 'RWE'"
    check "$name says that its stack is not executable" grep -qE "GNU_STACK .* RW " <<<"$segments"
    check "$name needs one library" test "$(readelf -dW "$BUILD/$name" | grep -c NEEDED)" = 1
    check "$name needs libdl.so.2" bash -c "ldd '$BUILD/$name' | grep -q 'libdl.so.2 =>'"
done
check "odraz-safe imports two functions" test "$(readelf -rW "$BUILD/odraz-safe" | grep -c R_X86_64)$(readelf -rW "$BUILD/odraz-safe" | grep -cE 'GLOB_DAT.*(dlopen|dlsym)')" = 22
check "no constructors" bash -c "! readelf -SW '$BUILD/odraz.elf' | grep -qE 'init_array|ctors'"
check "no path of the build machine" bash -c "! grep -qaF '$SOURCE' '$BUILD/odraz-safe'"

# Approximations differ between makers of processors; pictures must not
objdump -d --no-show-raw-insn "$BUILD/odraz.elf" >"$WORK/code"
check "no approximate reciprocals" bash -c "! grep -qE 'v?(rcp|rsqrt)[0-9]*[ps]s' '$WORK/code'"
check "(the search would find them)" grep -qE 'v?(sqrt|div)ps' "$WORK/code"
# What runs before the processor is known is baseline code
objdump -d --no-show-raw-insn "$BUILD/libhost.a" >"$WORK/host"
check "the host is free of AVX" bash -c "! grep -qE '%ymm|\bv[a-z0-9]+[ps][sd] ' '$WORK/host'"

# While it runs, nothing of its own is both writable and executable (drivers of OpenGL that compile shaders for the
# processor may have such memory: so an interval without them)
"$BUILD/odraz" --dump - --to 60 --size 640x360 --quality film >/dev/null 2>&1 &
pid=$!
PIDS+=($pid)
sleep 1.5
maps=$(cat /proc/$pid/maps)
check "it is unpacked and running" grep -q "r-xp.*00400000\|^00400000-[0-9a-f]* r-xp" <<<"$maps"
check "no memory is writable and executable" bash -c "! grep -q 'rwx' <<<'$maps'"
kill $pid

# The same commit makes the same bytes, in another place
check "configure a second build" bash -c "cmake -G '$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$BUILD/CMakeCache.txt")' -S '$SOURCE' -B '$WORK/second/build' >/dev/null"
check "build it" bash -c "cmake --build '$WORK/second/build' --target film -j 2 >/dev/null"
check "both builds are equal to the byte" cmp "$BUILD/odraz" "$WORK/second/build/odraz"
check "unpacked too" cmp "$BUILD/odraz-safe" "$WORK/second/build/odraz-safe"
finish

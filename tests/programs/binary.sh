# The shipped files: their segments, imports, instructions and libraries.
. "$(dirname "$0")/common.sh"
skip_unless readelf objdump

for name in odraz odraz-safe; do
    readelf -lW "$BUILD/$name" >"$WORK/segments"
    readelf -dW "$BUILD/$name" >"$WORK/dynamic"
    check "$name is a fixed-base executable" grep -q "EXEC (Executable" "$WORK/segments"
    check "$name has no segment that is writable and executable" lacks '(LOAD|GNU_STACK) .* RWE' "$WORK/segments"
    check "$name requests a stack that is not executable" grep -qE "GNU_STACK .* RW " "$WORK/segments"
    check "$name needs one library" test "$(grep -c NEEDED "$WORK/dynamic")" = 1
    check "... libdl.so.2, which is found" prints 'libdl.so.2 => /' ldd "$BUILD/$name"
done
readelf -rW "$BUILD/odraz-safe" >"$WORK/relocations"
check "odraz-safe imports two functions" test "$(grep -c R_X86_64 "$WORK/relocations")" = 2
check "... dlopen and dlsym" test "$(grep -cE 'GLOB_DAT.*(dlopen|dlsym)' "$WORK/relocations")" = 2
readelf -SW "$BUILD/odraz.elf" >"$WORK/sections"
check "no constructors" lacks 'init_array|ctors' "$WORK/sections"
check "no path of the build machine" lacks "$(sed 's/[.+*[^$()|]/\\&/g' <<<"$SOURCE")" "$BUILD/odraz-safe"

# Approximate instructions give other results on other makers' processors, and pictures must not differ
objdump -d --no-show-raw-insn "$BUILD/odraz.elf" >"$WORK/code"
check "no approximate reciprocals" lacks 'v?(rcp|rsqrt)[0-9]*[ps]s' "$WORK/code"
check "(the search would find them)" grep -qE 'v?(sqrt|div)ps' "$WORK/code"
# Code that runs before the processor is checked must not need AVX
avx='%ymm|\bv[a-z0-9]+[ps][sd] '
objdump -d --no-show-raw-insn "$BUILD/libhost.a" >"$WORK/host"
check "code of host/ uses no AVX" lacks "$avx" "$WORK/host"
for part in odraz/{answers,early,linux/entry,start,memory} odraz-windows/{windows/entry,windows/command_line}; do
    objdump -d --no-show-raw-insn "$BUILD/intro/CMakeFiles/${part%%/*}.elf.dir/start/${part#*/}.cpp.o" >"$WORK/start"
    check "... nor does start/${part#*/}" lacks "$avx" "$WORK/start"
done
check "(the search would find it)" grep -qE "$avx" "$WORK/code"

# The pages that are decoded first hold only code that runs before the rest is decoded
early() { # early MAP: prints the objects in these pages, except for the table of qualities, which any object may contain
    awk '/^\.[a-zA-Z]/ { on = /^\.early(data)?( |$)/ } /^ \.[a-z]/ { section = $1 }
        on && $NF ~ /\.o\)?$/ && $(NF - 1) ~ /^0x/ && $(NF - 1) != "0x0" && section !~ /kQualities/ { print $NF }' "$1" |
        sed 's|.*/||' | sort -u
}
neutral='answers.cpp.o early.cpp.o libengine.a(text.cpp.o) liboptions.a(options.cpp.o) liboutput.a(output.cpp.o)'
host='clock cpu error files library process threads window'
early_is() { # early_is PROGRAM OBJECT...: succeeds if early() prints just these objects
    printf '%s\n' "${@:2}" | sort >"$WORK/expected"
    early "$WORK/$1.map" | diff "$WORK/expected" - >&2
}
cp "$BUILD/odraz.map" "$BUILD/odraz-windows.map" "$WORK"
check "the part that is decoded first holds these objects and no others" early_is odraz $neutral $(printf 'libhost.a(%s.cpp.o) ' $host)
check "... for Windows, too" early_is odraz-windows $neutral command_line.cpp.o $(printf 'libhost_windows.a(%s.cpp.o) ' $host calls context)
for intruder in 'libplay.a(film_clock.cpp.o)' 'libengine.a(clock.cpp.o)' 'intro/CMakeFiles/odraz.elf.dir/main.cpp.o'; do
    awk -v line=" .text.intruder 0x0000000000402000       0x29 $intruder" '{ print } /^\.early / { print line }' "$BUILD/odraz.map" >"$WORK/odraz.map"
    early_is odraz $neutral $(printf 'libhost.a(%s.cpp.o) ' $host) 2>/dev/null
    check "(${intruder##*/} in that part would be found)" test $? = 1
done

# The film for Windows, made from the same objects
objdump -d --no-show-raw-insn "$BUILD/odraz-windows.elf" >"$WORK/windows"
objdump -d --no-show-raw-insn "$BUILD/libhost_windows.a" >"$WORK/host"
check "odraz.exe names five libraries and no others" test "$(grep -aoiE '[a-z0-9_-]+\.(dll|drv)' "$BUILD/odraz-safe.exe" | tr A-Z a-z | sed -E "s/.*(gdi32|kernel32|opengl32|user32|winmm)\\./\\1./" | sort -u | tr '\n' ' ')" = "gdi32.dll kernel32.dll opengl32.dll user32.dll winmm.dll "
objdump -p "$BUILD/odraz.exe" >"$WORK/headers"
check "... and imports from one" test "$(grep -c 'DLL Name: ' "$WORK/headers")" = 1 -a "$(grep -c 'DLL Name: kernel32.dll' "$WORK/headers")" = 1
check "its code of host/ uses no AVX" lacks "$avx" "$WORK/host"
for code in code windows; do
    check "no code keeps data below the stack pointer (red zone)" lacks '[^x]-0x[0-9a-f]+\(%rsp' "$WORK/$code"
    check "no code uses the segments fs and gs" lacks '%[fg]s:' "$WORK/$code"
done
g++ -O2 -fno-pic -fstack-protector-all -x c++ -c -o "$WORK/red.o" - <<<'int f(int *p) { volatile int a[4]; a[*p] = 1; return a[*p]; }'
g++ -O2 -fno-pic -fno-stack-protector -x c++ -c -o "$WORK/zone.o" - <<<'int f(int *p) { volatile int a[4]; a[*p] = 1; return a[*p]; }'
check "(both would be found)" test "$(objdump -d "$WORK/red.o" | grep -c '%fs:')" -gt 0 -a "$(objdump -d --no-show-raw-insn "$WORK/zone.o" | grep -cE '[^x]-0x[0-9a-f]+\(%rsp')" -gt 0
# Windows calls one of the film's functions, which must restore all of these registers
awk '/^[0-9a-f]+ <.*receive.*>:/ { on = 1 } /^$/ { on = 0 } on' "$WORK/host" | grep -oE 'movaps +%xmm[0-9]+,[(0-9]' | grep -oE 'xmm[0-9]+' | sort -u >"$WORK/kept"
check "functions that Windows calls save xmm6 to xmm15" test "$(tr '\n' ' ' <"$WORK/kept")" = "xmm10 xmm11 xmm12 xmm13 xmm14 xmm15 xmm6 xmm7 xmm8 xmm9 "

# While the film runs, none of its memory is both writable and executable. OpenGL drivers that compile shaders for the
# processor may have such memory, so this picture needs no OpenGL. The film waits, since the pipe is too small for it
exec 8< <(exec "$BUILD/odraz" --dump - --from 20 --to 20.04 --size 1280x720 --quality draft)
pid=$!
LC_ALL=C IFS= read -r -N 2 -u 8 magic
check "it runs" test "$magic" = P6
cat /proc/$pid/maps >"$WORK/maps"
exec 8<&-
check "... unpacked" grep -q "^00400000-[0-9a-f]* r-xp" "$WORK/maps"
check "... and no memory is writable and executable" lacks rwx "$WORK/maps"
finish

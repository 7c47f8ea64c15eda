# The same commit makes the same bytes when it is built and packed in another place.
. "$(dirname "$0")/../common.sh"
skip_unless strip
generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$BUILD/CMakeCache.txt")
second=$WORK/second/build
check "configure a second build" prints "Build files have been written" cmake -G "$generator" -S "$SOURCE" -B "$second"
check "build programs and packer" prints odraz cmake --build "$second" --target odraz.elf odraz-windows.elf pack -j 2
strip --strip-all -o "$WORK/odraz-safe" "$second/odraz.elf"
check "both builds are equal to the byte, unpacked" cmp "$BUILD/odraz-safe" "$WORK/odraz-safe"
model=(--model "$SOURCE/intro/odraz.model" --safe-name odraz-safe)
check "it packs the stripped film as it packs the one with symbols" prints 'bytes left' "$second/pack" "$WORK/odraz-safe" -o "$WORK/odraz" "${model[@]}"
check "... to the same bytes" cmp "$BUILD/odraz" "$WORK/odraz"
check "it makes the film for Windows" "$second/pack" "$second/odraz-windows.elf" -o "$WORK/odraz-safe.exe" --pe --plain >/dev/null
check "... the same" cmp "$BUILD/odraz-safe.exe" "$WORK/odraz-safe.exe"
check "... packs it" prints 'bytes left' "$second/pack" "$second/odraz-windows.elf" -o "$WORK/odraz.exe" --pe "${model[@]}"
check "... to the same bytes" cmp "$BUILD/odraz.exe" "$WORK/odraz.exe"
finish

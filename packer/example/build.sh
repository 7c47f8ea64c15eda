#!/usr/bin/env -S bash -p
# build.sh PACK FOLDER [--pe]: builds FOLDER/hello.elf and packs it to FOLDER/hello. With --pe, for Windows:
# FOLDER/hello_windows.elf and hello.exe.
set -euo pipefail
here=$(dirname "$0")
name=hello out=hello library=libdl.so.2 functions=(dlopen dlsym) packing=()
[ "${3-}" != --pe ] || name=hello_windows out=hello.exe library=kernel32.dll functions=(LoadLibraryA GetProcAddress) packing=(--pe)
# A library with only the imported functions, for the linker
printf 'void %s(void) {}\n' "${functions[@]}" >"$2/$library.c"
gcc -shared -nostdlib -Wl,-soname,$library,--build-id=none "$2/$library.c" -o "$2/$library.so"
g++ -Os -ffreestanding -fno-exceptions -fno-asynchronous-unwind-tables -fno-stack-protector -fcf-protection=none \
    -mno-red-zone -fno-pic -no-pie -nostdlib \
    -Wl,--hash-style=sysv,--build-id=none,-z,noseparate-code,-z,norelro,-z,noexecstack \
    "$here/$name.cpp" "$2/$library.so" -o "$2/$name.elf"
"$1" "$2/$name.elf" -o "$2/$out" "${packing[@]}"

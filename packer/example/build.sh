#!/usr/bin/env bash
# build.sh PACK FOLDER: makes FOLDER/hello.elf and packs it to FOLDER/hello.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
# What the linker sees of libdl.so.2
printf 'void dlopen(void) {}\nvoid dlsym(void) {}\n' >"$2/libdl.c"
gcc -shared -nostdlib -Wl,-soname,libdl.so.2,--build-id=none "$2/libdl.c" -o "$2/libdl.so"
g++ -Os -ffreestanding -fno-exceptions -fno-asynchronous-unwind-tables -fno-stack-protector -fcf-protection=none \
    -fno-pic -no-pie -nostdlib -Wl,--hash-style=sysv,--build-id=none,-z,noseparate-code,-z,norelro,-z,noexecstack \
    "$here/hello.cpp" "$2/libdl.so" -o "$2/hello.elf"
"$1" "$2/hello.elf" -o "$2/hello"

# Packs programs of many compilers: they behave as before, and are smaller than xz makes them. The table at the end is
# in packer/README.md.
. "$(dirname "$0")/../common.sh"
skip_unless gcc g++ xz
pack=$BUILD/pack programs=$SOURCE/tests/programs/long/programs
cd "$WORK" || exit 1
: >table

# same NAME PROGRAM COMMAND: strips and packs the program; succeeds if COMMAND, which runs ./run, prints the same
# for both
same() {
    local name=$1 packed fast small began took
    mkdir -p before after quick
    cp -L "$2" before/run && strip -o stripped "$2" 2>/dev/null || cp -L "$2" stripped
    "$pack" stripped -o after/run >/dev/null && "$pack" stripped -o quick/run --fast >/dev/null || return 1
    (cd before && transcript bash -c "$3") >wanted
    began=${EPOCHREALTIME/[.,]/}
    (cd after && transcript bash -c "$3") >got
    took=$((${EPOCHREALTIME/[.,]/} - began))
    diff wanted got && [ "$(wc -l <got)" -gt 1 ] && grep -qx 'status [0-9]' got || return 1
    began=${EPOCHREALTIME/[.,]/}
    (cd quick && transcript bash -c "$3") >got
    fast=$((${EPOCHREALTIME/[.,]/} - began))
    diff wanted got || return 1
    small=$(xz --x86 --lzma2=preset=9e --stdout -- stripped | wc -c) packed=$(stat -c %s after/run)
    awk -v name="$name" -v file="$(stat -c %s stripped)" -v small=$small -v packed=$packed -v quick="$(stat -c %s quick/run)" \
        -v took=$took -v fast=$fast 'BEGIN { printf "| %s | %d | %d | %d | %.2f | %.1f | %d | %.2f | %.1f |\n",
        name, file, small, packed, packed / small, took / 1e6, quick, quick / small, fast / 1e6 }' >>table
    [ "$(stat -c %s stripped)" -lt 100000 ] || echo "$small $packed $(noise stripped) $name" >>large
}
# noise FILE: prints the bytes in blocks of 4 KB that xz cannot compress, such as curl's manual, which is compressed
noise() { split -b 4096 --filter='xz -9e | wc -c' "$1" | awk '$1 > 4000 { sum += 4096 } END { print sum + 0 }'; }
# try NAME PROGRAM COMMAND: checks the program with same() if it is installed
try() {
    [ -x "$2" ] || { echo "not checked: $1"; return; }
    check "$1" same "$@"
}

for compiler in gcc clang; do
    command -v $compiler >/dev/null || { echo "not checked: $compiler"; continue; }
    for options in "" -no-pie -static -static-pie; do
        rm -f hello
        $compiler -O2 "$programs/hello.c" $options -o hello
        try "hello of C, $compiler $options" hello ./run
    done
done
command -v musl-gcc >/dev/null && musl-gcc -O2 -static "$programs/hello.c" -o hello_musl
try "hello of C, static, musl" hello_musl ./run
command -v rustc >/dev/null && rustc -O "$programs/hello.rs" -o hello_rust 2>/dev/null
try "hello of Rust" hello_rust ./run
printf '%s\n' 'package main' 'import "fmt"' 'func main() { c := make(chan int); go func() { c <- 6 * 7 }(); fmt.Println("hello", <-c) }' >hello.go
command -v go >/dev/null && GOCACHE=$WORK/cache GOFLAGS=-mod=mod go build -o hello_go hello.go
try "hello of Go, with a goroutine" hello_go ./run
g++ -O2 "$programs/triangle.cpp" -o triangle -lSDL2 -lGL 2>/dev/null
command -v xvfb-run >/dev/null && try "SDL2 and OpenGL, C++" triangle 'xvfb-run -a ./run 3'
try bash /usr/bin/bash './run -c "for i in 1 2 3; do echo \$((i * i)); done; exit 4"'
try busybox /usr/bin/busybox '(exec -a busybox ./run awk "BEGIN { print 6 * 7 }"); (exec -a busybox ./run sh -c "echo a | tr a b; exit 4")'
try curl /usr/bin/curl './run -sS file:///etc/hostname; ./run --version'
try vim /usr/bin/vim.basic 'echo one >file; ./run -es -u NONE -c "s/one/two/" -c wq file; cat file'
try python3.11 /usr/bin/python3.11 './run -c "import sys, json, ctypes, threading; print(json.dumps([1, {}])); sys.exit(3)"'
try radiosity "$BUILD/radiosity" './run --help'

sort -t'|' -k3n table >sorted
echo '| | file | xz -9e --x86 | packed | of xz | s | fast | of xz | s |'
cat sorted
check "programs over 100 KB take at most .80 of xz, not counting noise" awk '
    ($2 - $3) / ($1 - $3) > .8 { print; bad = 1 } END { exit bad || NR < 3 }' large
finish

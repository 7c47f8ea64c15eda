# The packer with programs as compilers make them: packed, they must behave as before. With "all" as the second
# argument it packs another large one.
. "$(dirname "$0")/common.sh"
skip_unless gcc
pack=$BUILD/pack
cd "$WORK" || exit 1

# same NAME: packs the program NAME, and both do the same with two arguments
fast=()
same() {
    "$pack" "$1" -o "$1.packed" "${fast[@]}" >/dev/null || return 1
    mkdir -p before after
    ln -f "$1" before/run && ln -f "$1.packed" after/run # under one name, which they may print
    (cd before && transcript ./run a 'b c') >wanted
    (cd after && transcript ./run a 'b c') >got
    cmp wanted got && [ "$(wc -l <got)" -gt 1 ]
}

# Constructors before main, destructors after it, thread-local storage, the heap, the environment and the auxiliary
# vector: everything that a loader handles. A page of bss must be zeros. The vector must describe the program itself
cat >c.c <<'END'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <elf.h>
#include <sys/auxv.h>
static __thread int local = 40;
static char zeros[100000];
static int (*volatile compare)(const char *, const char *) = strcmp; // by IRELATIVE in static programs
static const char *names[] = {"relative", "addresses"};
extern int main(int, char **);
__attribute__((constructor)) static void first(void) { puts("first"); }
__attribute__((destructor)) static void last(void) { puts("last"); }
int main(int count, char **words) {
    long sum = 0;
    const Elf64_Phdr *headers = (void *)getauxval(AT_PHDR);
    for (unsigned i = 0; i < getauxval(AT_PHNUM); ++i) sum += headers[i].p_type == PT_TLS;
    for (int i = 0; i < 100000; ++i) sum += zeros[i];
    char *block = malloc(300000), *more = malloc(100);
    memset(block, 1, 300000);
    strcpy(more, names[1]);
    printf("%d words, the last '%s'; %d, %ld, %s %s, %d, %s\n", count, words[count - 1], local += count, sum, names[0],
           more, compare(more, "addresses"), getenv("SAID"));
    free(block);
    fputs("to stderr\n", stderr);
    return (unsigned long)main > (unsigned long)headers ? 7 : 8;
}
END
cat >rust.rs <<'END'
fn main() {
    let threads: Vec<_> = (0..4).map(|i| std::thread::spawn(move || i * i)).collect();
    let sum: i32 = threads.into_iter().map(|t| t.join().unwrap()).sum();
    println!("{} {:?}", sum, std::env::args().nth(1));
    std::process::exit(4)
}
END
export SAID=words

check "compiles a program" gcc -O1 c.c -o c
check "... which runs packed" same c
fast=(--fast) # for the others, which takes a third of the time
for options in -no-pie "-static -Wl,-s" ${2:+"-static-pie -Wl,-s"} "-no-pie -Wl,-s" "-Wl,-z,now -Wl,-z,pack-relative-relocs" "-Wl,-z,noseparate-code" "-Wl,-z,max-page-size=0x10000"; do
    gcc -O1 c.c $options -o variant 2>/dev/null || { echo "not checked: gcc cannot link with $options"; continue; }
    check "... linked with $options, too" same variant
done
if command -v g++ >/dev/null; then
    check "compiles C++" g++ -O1 -pthread "$SOURCE/tests/programs/pack/thrown.cpp" -o cpp
    check "... with threads and exceptions, the same packed" same cpp
fi
for compiler in clang musl-gcc; do
    command -v $compiler >/dev/null && $compiler -O1 c.c -o other 2>/dev/null || { echo "not checked: $compiler"; continue; }
    check "of $compiler, the same packed" same other
done
if command -v rustc >/dev/null && rustc -O -C strip=symbols rust.rs -o rust 2>/dev/null; then
    check "of rustc, the same packed" same rust
else
    echo "not checked: rustc"
fi

is_small() {
    prints '^c.packed: ' "$pack" c -o c.packed
    less "$(sed -nE 's/^c.packed: .*\(([0-9]+) of them.*/\1/p' printed)" 3201
}
check "stub and headers take 3,200 bytes at most" is_small

# Opened again
check "finds that a packed one is whole" prints 'whole' "$pack" --test c.packed
check "makes it plain" "$pack" -d c.packed -o plain
transcript ./plain x >got
transcript ./c x >wanted
check "... the same" cmp wanted got

# Errors begin with the name, and nothing of the program runs
cp c.packed damaged
flip damaged 3800
check "a damaged one prints that" refuses 1 "./damaged: damaged: get it afresh" ./damaged
head -c 3900 c.packed >short && chmod +x short
check "... one cut short, too" refuses 1 "./short: damaged: get it afresh" ./short
check "... one without memory" refuses 1 "./c.packed: not enough free memory" bash -c 'ulimit -v 30000; exec ./c.packed'
sed 's/ld-linux-x86-64.so.2/ld-linux-x86-64.so.9/' c >lost && chmod +x lost
"$pack" lost -o lost.packed >/dev/null
check "a missing interpreter, too" refuses 1 "./lost.packed: interpreter missing" ./lost.packed
if can_be_unwritten; then
    check "that it may not run" refuses 1 "./c.packed: may not run packed" "${UNWRITTEN[@]}" ./c.packed
fi
called() { "$pack" c -o named --name hello --safe-name hello-safe >/dev/null && "$pack" --test named >/dev/null; }
check "packed with names, it is whole" called
flip named 3800
check "... and prints its name" refuses 1 "hello is damaged" ./named
if can_be_unwritten; then
    called
    check "... or that of another" refuses 1 "use hello-safe" "${UNWRITTEN[@]}" ./named
fi
check "with few contexts" "$pack" c -o c.fast --fast
transcript ./c.fast x >got
transcript ./c x >wanted
check "... the same" cmp wanted got

# Programs that other tools have changed
cp c moved
if command -v patchelf >/dev/null && patchelf --add-needed libm.so.6 moved && patchelf --set-interpreter "/lib64/$(printf '../lib64/%.0s' {1..6})ld-linux-x86-64.so.2" moved; then
    check "with its interpreter's name moved, the same packed" same moved
else
    echo "not checked: patchelf is not installed"
fi
perl -e 'local $/; $_ = <>; my ($at, $n) = (unpack("Q", substr $_, 32), unpack "S", substr $_, 56);
    my (@all, $last, $end);
    for my $i (0 .. $n - 1) {
        push @all, [unpack "LLQ6", substr $_, $at + 56 * $i, 56];
        $end = $all[$i][3] + $all[$i][6] and $last = $i if $all[$i][0] == 1;
    }
    $_ .= "\0" x (-length($_) % 4096);
    my ($to, $place, $size) = (length, ($end + 4095) & ~4095, 56 * ($n + 1));
    splice @all, $last + 1, 0, [1, 4, $to, $place, $place, $size, $size, 4096];
    $_->[0] == 6 and @$_[2 .. 6] = ($to, $place, $place, $size, $size) for @all;
    substr($_, 32, 8) = pack "Q", $to;
    substr($_, 56, 2) = pack "S", $n + 1;
    print $_, map { pack "LLQ6", @$_ } @all' c >behind && chmod +x behind
check "with its program headers at its end, the same packed" same behind

# The file that is written
check "a file keeps its mode" eval 'cp c private && chmod 750 private && umask 022 && "$pack" private -o p --fast >/dev/null && test "$(stat -c %a p)" = 750'
check "... unpacked, too" eval 'chmod 710 p && "$pack" -d p -o q && test "$(stat -c %a q)" = 710'
check "a symbolic link stays one" eval 'mkdir target && ln -s target/file link && "$pack" c -o link --fast >/dev/null && test -L link && "$pack" --test target/file >/dev/null'
check "... also if its target is there" eval '"$pack" c -o link --fast --name other >/dev/null && test -L link && grep -qa "other is damaged" target/file'

# Files that it refuses to pack
check "a packed one is refused" refuses 2 "packed already" "$pack" c.packed -o x
cp c setuid && chmod u+s setuid
check "one with setuid" refuses 2 "setuid" "$pack" setuid -o x
gcc -c c.c -o object.o
check "an object file" refuses 2 "not an executable" "$pack" object.o -o x
echo 'int f(void) { return 1; }' >f.c
gcc -shared -fPIC f.c -o library.so
check "a library" refuses 2 "pack programs, not libraries" "$pack" library.so -o x
libc=$(ldd c | grep -o '/[^ ]*libc.so.6') loader=$(ldd c | grep -o '/[^ ]*ld-linux[^ ]*')
for library in "$libc" "$loader"; do check "... one with an entry point" refuses 2 "a shared library: pack programs" "$pack" "$library" -o x; done
gcc -no-pie c.c -Wl,-Ttext-segment=0x8000 -o low 2>/dev/null
check "one where nothing may lie" refuses 2 "below 64 KiB" "$pack" low -o x
check "for Windows" refuses 2 "--loader is for Linux" "$pack" c -o x --loader --pe
check "with two choices of contexts" refuses 2 "--fast and --model" "$pack" c -o x --fast --model y
if command -v setcap >/dev/null && cp c capable && setcap cap_net_raw=p capable 2>/dev/null; then
    check "with file capabilities" refuses 2 "file capabilities" "$pack" capable -o x
else
    echo "not checked: files cannot be given capabilities here"
fi
cp c appended && head -c 1000 /dev/zero | tr "\0" x >>appended
check "a line warns of what is appended and left out" prints '1000 bytes appended' "$pack" appended -o "$WORK/y"
cp c padded && head -c 1000 /dev/zero >>padded
check "... but no padding" eval '"$pack" padded -o y >padded.out && ! grep appended padded.out'
check "over a budget" refuses 1 "over budget" bash -c "'$pack' c -o x --budget 1000 >/dev/null"
check "nothing is left behind" test ! -e x
finish

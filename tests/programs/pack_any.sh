# Packs programs of ordinary compilers, which must behave as before. With "all" as the second argument it also packs
# static programs, which contain glibc. (elf_test tests which programs are refused.)
. "$(dirname "$0")/common.sh"
skip_unless gcc
pack=$BUILD/pack small=(--model "$SOURCE/tests/support/small.model")
cd "$WORK" || exit 1

# same NAME OPTION...: packs the program NAME; succeeds if it does the same with two arguments as before
same() {
    "$pack" "$1" -o "$1.packed" "${@:2}" >packed.txt || return 1
    mkdir -p before after
    ln -f "$1" before/run && ln -f "$1.packed" after/run # the same name, which they may print
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
export SAID=words

check "compiles a program" gcc -O1 c.c -o c
check "... which runs packed" same c
check "... its stub and headers take 3,220 bytes at most" less "$(sed -nE 's/^c.packed: .*\(([0-9]+) of them.*/\1/p' packed.txt)" 3221
for options in ${2:+"-static -Wl,-s" "-static-pie -Wl,-s"} "-no-pie -Wl,-s" "-Wl,-z,now -Wl,-z,pack-relative-relocs" "-Wl,-z,noseparate-code" "-Wl,-z,max-page-size=0x4000"; do
    gcc -O1 c.c $options -o variant 2>/dev/null || { echo "not checked: gcc cannot link with $options"; continue; }
    check "... linked with $options, too" same variant "${small[@]}"
done
if command -v g++ >/dev/null; then
    check "compiles C++" g++ -O1 -pthread "$SOURCE/tests/programs/pack/thrown.cpp" -o cpp
    check "... with threads and exceptions: the same when packed" same cpp "${small[@]}"
fi
for compiler in clang musl-gcc "musl-gcc -static"; do
    command -v ${compiler% *} >/dev/null && $compiler -O1 c.c -o other 2>/dev/null || { echo "not checked: $compiler"; continue; }
    check "a program by $compiler: the same when packed" same other "${small[@]}"
done
# The packed program is checked and unpacked
check "--test reports that it is whole" prints 'whole' "$pack" --test c.packed
check "-d unpacks it" "$pack" -d c.packed -o plain
transcript ./plain x >got
transcript ./c x >wanted
check "... the same" cmp wanted got

# Errors begin with the program's name, and the program itself does not run
cp c.packed damaged
flip damaged 3800
check "a damaged program reports it" refuses 1 "./damaged: damaged: copy it again" ./damaged
head -c 3900 c.packed >short && chmod +x short
check "... one cut short, too" refuses 1 "./short: damaged: copy it again" ./short
check "... one without memory" refuses 1 "./c.packed: not enough free memory" bash -c 'ulimit -v 30000; exec ./c.packed'
for interpreter in lib64/lost=02 .=21 dev/null=80; do # a missing file, a folder, an empty file
    name=$(printf %27s "${interpreter%=*}" | tr ' ' /)
    sed "s|/lib64/ld-linux-x86-64.so.2|$name|" c >lost && chmod +x lost
    "$pack" lost -o lost.packed "${small[@]}" >/dev/null
    check "... with the interpreter $name, too" refuses 1 "./lost.packed: no interpreter: errno ${interpreter#*=}" ./lost.packed
done
for call in open openat; do # a filter of the kernel refuses this call
    check "... compiles a filter that refuses $call" gcc -DCALL=SYS_$call "$SOURCE/tests/programs/pack/deny.c" -o deny_$call
done
check "... runs without open, as its interpreter does" prints "the last 'x'" eval './deny_open ./c.packed x; true'
check "... and prints that it cannot openat" refuses 1 "./c.packed: no interpreter: errno 01" ./deny_openat ./c.packed
if has_mdwe; then
    check "... and that it may not run packed" refuses 1 "./c.packed: may not run packed" "${MDWE[@]}" ./c.packed
fi
check "a program packed with --safe-name is whole" eval '"$pack" c -o named --safe-name hello-safe "${small[@]}" >/dev/null && "$pack" --test named >/dev/null'
if has_mdwe; then check "... and names the program to use instead" refuses 1 "./named: use hello-safe" "${MDWE[@]}" ./named; fi

# A program that another tool has changed
cp c moved
if command -v patchelf >/dev/null && patchelf --add-needed libm.so.6 moved && patchelf --set-interpreter "/lib64/$(printf '../lib64/%.0s' {1..6})ld-linux-x86-64.so.2" moved; then
    check "with its interpreter's name moved: the same when packed" same moved "${small[@]}"
else
    echo "not checked: patchelf is not installed"
fi

# The file that is written
check "a file keeps its mode" eval 'cp c private && chmod 750 private && umask 022 && "$pack" private -o p --fast >/dev/null && test "$(stat -c %a p)" = 750'
check "... unpacked, too" eval 'chmod 710 p && "$pack" -d p -o q && test "$(stat -c %a q)" = 710'
check "a symbolic link stays a link" eval 'mkdir target && ln -s target/file link && "$pack" c -o link "${small[@]}" >/dev/null && test -L link && "$pack" --test target/file >/dev/null'
cp c appended && head -c 1000 /dev/zero | tr "\0" x >>appended
check "a line reports appended bytes, which are left out" prints '1000 bytes appended' "$pack" appended -o y "${small[@]}"

# Files that are refused for their mode or their capabilities
cp c setuid && chmod u+s setuid
check "a setuid program" refuses 2 "setuid" "$pack" setuid -o x
if command -v setcap >/dev/null && cp c capable && setcap cap_net_raw=p capable 2>/dev/null; then
    check "with file capabilities" refuses 2 "file capabilities" "$pack" capable -o x
else
    echo "not checked: files cannot be given capabilities here"
fi
check "nothing is left behind" test ! -e x
finish

# A packed program sees its process, and other programs see it, as if it had not been packed.
. "$(dirname "$0")/common.sh"
skip_unless gcc
pack=$BUILD/pack
cd "$WORK" || exit 1
mkdir lib

# A library in $ORIGIN/lib, a preloaded library, and a program that prints what it sees
echo 'int found(void) { return 42; }' >found.c
echo 'int rand(void) { return -1234; }' >preloaded.c
cat >c.c <<'END_OF_C'
#define _GNU_SOURCE
#include <link.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>
int found(void);
static int headers, objects, vdso;
static int count(struct dl_phdr_info *info, size_t size, void *data) {
    // The program comes first, by the headers that it was linked with
    if (!objects++) headers = info->dlpi_phnum;
    vdso += info->dlpi_addr == getauxval(AT_SYSINFO_EHDR);
    return size == 0 || data != 0;
}
static void show(const char *what) { puts(what), fflush(stdout); }
static int deep(int n) { // uses n * 100 KB of stack
    volatile char block[100000];
    memset((char *)block, n, sizeof block);
    return n ? deep(n - 1) + block[n] - (char)n : 0;
}
int main(int words, char **word) {
    char self[1000] = "";
    if (readlink("/proc/self/exe", self, sizeof self - 1) < 0) return 1;
    if (words == 1 || strcmp(word[1], "wait")) {
        printf("called %s, is %s\n", strrchr(word[0], '/') ?: word[0], strrchr(self, '/') + 1);
        struct rlimit stack;
        getrlimit(RLIMIT_STACK, &stack);
        dl_iterate_phdr(count, 0);
        printf("%d: %d headers, %d vdso, a stack of %ld, rand %d\n", found(), headers, vdso, (long)stack.rlim_cur,
               rand());
        printf("%d of the stack\n", deep(70)); // 7 of 8 MB
        if (words > 1 && !strcmp(word[1], "abort")) printf("%p\n", (void *)&vdso), fflush(stdout), abort();
        return 3;
    }
    show("here");
    for (;;) pause();
}
END_OF_C
gcc -shared -fPIC found.c -o lib/libfound.so && gcc -shared -fPIC preloaded.c -o lib/preloaded.so
check "compiles a program" gcc -O1 -rdynamic c.c -Llib -lfound -Wl,-rpath,'$ORIGIN/lib' -o before
check "packs it" "$pack" before -o after --model "$SOURCE/tests/support/small.model"
mkdir b a && mv before b/run && mv after a/run && ln -s ../lib b/lib && ln -s ../lib a/lib
# both COMMAND: succeeds if the shell command, run in the folders of both programs, prints the same
both() {
    (cd b && transcript bash -c "$1") >wanted
    (cd a && transcript bash -c "$1") >got
    [ "$(wc -l <got)" -gt 1 ] && diff wanted got
}
check "\$ORIGIN, /proc/self/exe, headers, vDSO" both 'exec ./run'
check "... which it found" grep -q '^42: .* 1 vdso' got
check "any argv[0]" both 'exec -a "another name" ./run'
check "... it is printed" grep -q 'called another name, is run' got
check "by a path from elsewhere" both 'cd /; exec "$OLDPWD/run" x'
check "LD_PRELOAD" both 'LD_PRELOAD=$PWD/../lib/preloaded.so exec ./run'
check "... it is loaded" grep -q 'rand -1234' got
check "an unlimited stack" both 'ulimit -s unlimited; exec ./run'
check "... is printed" grep -q 'a stack of -1' got
check "a stack of 8 MB" both 'ulimit -s 8192; exec ./run'
check "without randomised addresses" both 'exec setarch -R ./run'
check "with closed descriptors" both 'exec ./run <&- 2>&-'

# Signals arrive during a long decoding
head -c 150000 /dev/urandom >noise
printf '%s\n' '.section .rodata' '.incbin "noise"' '.section .note.GNU-stack,"",@progbits' >noise.s
gcc -O1 c.c noise.s -Llib -lfound -Wl,-rpath,'$ORIGIN/lib' -o long && "$pack" long -o a/long --fast >/dev/null
check "a program of 150 KB of noise" test -x a/long
in_a() { cd a && exec "$@"; }
ignoring() { trap "" INT && in_a "$@"; }
in_background ignoring ./long x
stopped() { gone $pid || grep -q '^State:.*T' "/proc/$pid/status"; }
in_pieces() {
    local i
    for i in 1 2 3; do
        worked $pid 2 || break # on a busy machine it may end before it was stopped three times
        { kill -STOP $pid && await stopped && kill -CONT $pid && kill -WINCH $pid && kill -INT $pid; } || gone $pid || return 1
    done
    ended $pid
    [ $? = 3 ] && grep -q '^42: ' out
}
check "stopped and continued while it decodes, with signals that it ignores, it runs" in_pieces
ended_by_term() { # fails if the program ended before the signal: then it is tried again
    in_background in_a ./long x
    worked $pid 2 && kill -TERM $pid
    ended $pid
    [ $? = 143 ] && [ ! -s out ]
}
check "SIGTERM ends it while it decodes" await ended_by_term

# What other programs see
in_background in_a ./run wait
check "it waits" await grep -q here out
check "no memory is both writable and executable" bash -c "! grep ' rwx' /proc/$pid/maps"
# Debuggers get the packed file's headers from the kernel, so they need the program's address
base=0x$(grep -m 1 '/run$' /proc/$pid/maps | cut -d- -f1) libc=0x$(grep -m 1 'libc[.-]' /proc/$pid/maps | cut -d- -f1)
if command -v gdb >/dev/null; then
    gdb -nx -batch -p $pid -ex "symbol-file b/run -o $base" -ex "add-symbol-file $(grep -om 1 '/.*libc[.-].*' /proc/$pid/maps) -o $libc" -ex bt >seen 2>&1
    check "gdb attaches to it, and finds where it waits" grep -q 'in main ()' seen
else
    echo "not checked: gdb is not installed"
fi
kill $pid
if [[ $(</proc/sys/kernel/core_pattern) != [\|/]* ]]; then
    { (ulimit -c unlimited && cd a && exec ./run abort) >got 2>&1; } 2>/dev/null
    core=$(ls a/core* 2>/dev/null | head -n 1)
    check "abort leaves a core" test -n "$core"
    if command -v gdb >/dev/null; then
        gdb -nx -batch -c "$core" -ex "print *(int *)$(tail -n 1 got)" >seen 2>&1
        check "... in which gdb finds its variables" grep -q '= 1$' seen
    fi
else
    echo "not checked: cores are not written where they can be found"
fi
finish

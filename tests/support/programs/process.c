// Prints what it sees of its process; with `wait` it only waits. found() is in a library in $ORIGIN/lib.
#define _GNU_SOURCE
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <sys/resource.h>
#include <unistd.h>
int found(void);
static int headers, objects, vdso;
static int count(struct dl_phdr_info *info, size_t size, void *data) {
    // The program comes first, by the headers that it was linked with
    if (!objects++) headers = info->dlpi_phnum;
    vdso += info->dlpi_addr == getauxval(AT_SYSINFO_EHDR);
    return size == 0 || data != 0;
}
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
        printf("%d: %d headers, %d vdso, a stack of %ld, rand %d\n", found(), headers, vdso,
               (long)stack.rlim_cur, rand());
        printf("%d of the stack\n", deep(70)); // 7 of 8 MB
        if (words > 1 && !strcmp(word[1], "abort")) printf("%p\n", (void *)&vdso), fflush(stdout), abort();
        return 3;
    }
    puts("here"), fflush(stdout);
    for (;;) pause();
}

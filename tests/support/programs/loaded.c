// Constructors before main, destructors after it, thread-local storage, the heap, the environment and the
// auxiliary vector: everything that a loader handles. Its bss must be zeros. The vector must describe the
// program itself.
#include <elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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
    printf("%d words, the last '%s'; %d, %ld, %s %s, %d, %s\n", count, words[count - 1], local += count, sum,
           names[0], more, compare(more, "addresses"), getenv("SAID"));
    free(block);
    fputs("to stderr\n", stderr);
    return (unsigned long)main > (unsigned long)headers ? 7 : 8;
}

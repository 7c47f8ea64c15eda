// The smallest program made for the packer; build.sh builds it. The rules in short (../README.md has all): a
// fixed-base executable that starts at _start without crt1, has its writable data on separate pages after
// code and constants, has no constructors and no thread-local storage, and imports only dlopen and dlsym. It
// opens libraries by name. libc is already loaded, because the program has an interpreter.
extern "C" {
__attribute__((noplt)) void *dlopen(const char *name, int mode);
__attribute__((noplt)) void *dlsym(void *library, const char *name);
}

// ld.so leaves rsp aligned to 16, pointing to argc.
__asm__(".globl _start\n"
        "_start:\n"
        "    mov %rsp, %rdi\n"
        "    call start\n");

static int theSum = 40; // data must survive packing too
static int theZeros[1000];

extern "C" [[noreturn]] void start(long *stack) {
    void *libc = dlopen("libc.so.6", 2 /* RTLD_NOW */);
    auto print = (int (*)(const char *, ...))dlsym(libc, "printf");
    auto leave = (void (*)(int))dlsym(libc, "exit");
    for (int i = 0; i < 1000; ++i) theSum += theZeros[i];
    print("hello, %d words, %d\n", (int)stack[0], theSum + 2);
    leave(7);
    __builtin_unreachable();
}

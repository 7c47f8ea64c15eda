// The smallest program for pack --pe; build.sh builds it. It is linked as ELF like hello.cpp and must keep
// the same rules, except that it imports LoadLibraryA and GetProcAddress from kernel32.dll. Calls to and from
// Windows use Microsoft's convention, ms_abi; everything else is as on Linux.
#define WINDOWS __attribute__((ms_abi))

extern "C" {
__attribute__((noplt)) WINDOWS void *LoadLibraryA(const char *name);
__attribute__((noplt)) WINDOWS void *GetProcAddress(void *library, const char *name);
}

static int theSum = 40; // data must survive packing too
static int theZeros[1000];

// Windows calls this function, so it has Microsoft's convention.
extern "C" [[noreturn]] WINDOWS void _start() {
    void *kernel = LoadLibraryA("kernel32.dll");
    auto output = (void *(WINDOWS *)(unsigned))GetProcAddress(kernel, "GetStdHandle");
    auto write = (int(WINDOWS *)(void *, const void *, unsigned, unsigned *, void *))GetProcAddress(
        kernel, "WriteFile");
    auto leave = (void(WINDOWS *)(unsigned))GetProcAddress(kernel, "ExitProcess");
    for (int i = 0; i < 1000; ++i) theSum += theZeros[i];
    char text[] = "hello, ..\n";
    text[7] = (char)('0' + (theSum + 2) / 10), text[8] = (char)('0' + (theSum + 2) % 10);
    unsigned written;
    write(output(-11u /* STD_OUTPUT_HANDLE */), text, 10, &written, nullptr);
    leave(7);
    __builtin_unreachable();
}

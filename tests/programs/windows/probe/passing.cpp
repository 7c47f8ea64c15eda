// How calls reach Windows: from our calling convention through calls.cpp. Functions of our own replace
// Windows's and record what arrives.
#include "probe.h"

#include "host/library.h"

using namespace odraz;

namespace probe {

// The arguments of the last call of probeRecord
extern "C" {
uint64_t probeCame[12], probeCameStack, probeCalls, probeElsewhere;
float probeCameFloats[4];
void probeRecord();
void probeWrong();
}
__asm__(".text\n"
        "probeRecord:\n"
        "mov %rcx, probeCame\n mov %rdx, probeCame + 8\n mov %r8, probeCame + 16\n mov %r9, probeCame + 24\n"
        "mov 40(%rsp), %rax\n mov %rax, probeCame + 32\n mov 48(%rsp), %rax\n mov %rax, probeCame + 40\n"
        "mov 56(%rsp), %rax\n mov %rax, probeCame + 48\n mov 64(%rsp), %rax\n mov %rax, probeCame + 56\n"
        "mov 72(%rsp), %rax\n mov %rax, probeCame + 64\n mov 80(%rsp), %rax\n mov %rax, probeCame + 72\n"
        "mov 88(%rsp), %rax\n mov %rax, probeCame + 80\n mov 96(%rsp), %rax\n mov %rax, probeCame + 88\n"
        "movss %xmm0, probeCameFloats\n movss %xmm1, probeCameFloats + 4\n"
        "movss %xmm2, probeCameFloats + 8\n movss %xmm3, probeCameFloats + 12\n"
        "mov %rsp, probeCameStack\n incq probeCalls\n"
        // Overwrite what the callee may change: room for four arguments, the arguments, and these registers
        "mov $-1, %rax\n"
        "mov %rax, 8(%rsp)\n mov %rax, 16(%rsp)\n mov %rax, 24(%rsp)\n mov %rax, 32(%rsp)\n"
        "mov %rax, 40(%rsp)\n mov %rax, 48(%rsp)\n mov %rax, 56(%rsp)\n mov %rax, 64(%rsp)\n"
        "mov %rax, 72(%rsp)\n mov %rax, 80(%rsp)\n mov %rax, 88(%rsp)\n mov %rax, 96(%rsp)\n"
        "mov %rax, %rcx\n mov %rax, %rdx\n mov %rax, %r8\n mov %rax, %r9\n mov %rax, %r10\n mov %rax, %r11\n"
        "mov $0x1020304050607080, %rax\n ret\n"
        "probeWrong: incq probeElsewhere\n ret\n");

namespace {

constexpr int kSlots = sizeof(windows::Functions) / sizeof(void *);

// Whether a call of `ours` reaches only `slot`, with twelve arguments, and returns correctly.
bool passes(void *ours, int slot) {
    void **slots = (void **)&odrazFunctions, *usual[kSlots];
    for (int i = 0; i < kSlots; ++i) usual[i] = slots[i], slots[i] = (void *)probeWrong;
    slots[slot] = (void *)probeRecord;
    uint64_t arguments[12];
    for (uint64_t i = 0; i < 12; ++i) arguments[i] = 0xfedcba9876543200 + 16 * (uint64_t)slot + i;
    probeCalls = probeElsewhere = 0;
    Kept after;
    callOurs(ours, arguments, after);
    for (int i = 0; i < kSlots; ++i) slots[i] = usual[i];
    for (int i = 0; i < 12; ++i)
        if (probeCame[i] != arguments[i]) return false;
    return probeCalls == 1 && !probeElsewhere && keptByOurs(after) && after.result == 0x1020304050607080 &&
           (probeCameStack & 15) == 8;
}

// The two conventions disagree on registers where floats and integers are mixed.
template <class T> constexpr bool isFloat = __is_same(T, float) || __is_same(T, double);
template <class R, class... A> constexpr bool mayPass(R (*)(A...)) {
    constexpr int floats = (0 + ... + (int)isFloat<A>), all = sizeof...(A);
    return (!floats || (floats == all && all <= 4)) && all <= 12 && !isFloat<R>;
}

} // namespace

void passing() {
    int slot = 0, wrong = 0, mixed = 0;
    // Prints each function that fails
#define PASSES(name)                                                                                         \
    if (!passes((void *)&name, slot)) ++wrong, check("a call passes: " #name, false, slot);                  \
    if (!mayPass(&name)) ++mixed, check("floats and integers are not mixed: " #name, false);                 \
    ++slot;
    ODRAZ_KERNEL32(PASSES)
    ODRAZ_USER32(PASSES)
    ODRAZ_GDI32(PASSES)
    ODRAZ_OPENGL32(PASSES)
    ODRAZ_WINMM(PASSES)
#undef PASSES
    check("each function of Windows gets what ours is given, up to 12 arguments", !wrong && slot > 50, slot);
    int first = slot;
#define PASSES(name)                                                                                         \
    if (!passes(odrazGlCalls + 8 * (slot - first), slot))                                                    \
        ++wrong, check("a call passes: " #name, false, slot);                                                \
    if (!mayPass(&name)) ++mixed, check("floats and integers are not mixed: " #name, false);                 \
    ++slot;
    ODRAZ_GL(PASSES)
    PASSES(glClipControl)
#undef PASSES
    check("... and of OpenGL", !wrong && slot == kSlots && slot > first + 50, slot);
    check("floats and integers are not mixed", !mixed);
    {
        Instead clear(odrazFunctions.gl, (void *)probeRecord);
        ((void (*)(float, float, float, float))(void *)odrazGlCalls)(1, 2, 3, 4);
    }
    check("floats get there", probeCameFloats[0] == 1 && probeCameFloats[1] == 2 && probeCameFloats[2] == 3 &&
                                  probeCameFloats[3] == 4);

    // What is loaded stands where its caller looks for it
    int missing = 0;
    void **slots = odrazFunctions.kernel32;
#define IS_LOADED(name) missing += *slots++ != function("kernel32.dll", #name);
    ODRAZ_KERNEL32(IS_LOADED)
    check("kernel32's functions are found", !missing, missing);
    check("... winmm's", !loadFunctions("winmm.dll", ODRAZ_WINMM(ODRAZ_NAME), odrazFunctions.winmm));
    slots = odrazFunctions.winmm;
#define IS_LOADED_TOO(name) missing += *slots++ != function("winmm.dll", #name);
    ODRAZ_WINMM(IS_LOADED_TOO)
    check("... each in its place", !missing, missing);
    check("a library that is not there is named", loadFunctions("no-such.dll", "a\0", slots) != nullptr);

    // Real calls, with 2 to 7 arguments
    WCHAR self[600];
    uint32_t size = GetModuleFileNameW(nullptr, self, 600), got = 0;
    HANDLE file = CreateFileW(self, 0x80000000, 7, nullptr, 3, 0, nullptr);
    check("a file opens by 7 arguments", size && file != windows::kInvalid);
    auto read = (PROBE_WINDOWS int (*)(HANDLE, void *, uint32_t, uint32_t *, void *))function("kernel32.dll",
                                                                                              "ReadFile");
    char magic[2] = {};
    check("... which is this program",
          read(file, magic, 2, &got, nullptr) && got == 2 && magic[0] == 'M' && magic[1] == 'Z');
    check("... and closes once",
          CloseHandle(file) && !CloseHandle(file) && GetLastError() == windows::kInvalidHandle,
          GetLastError());
    char text[9] = {};
    static const WCHAR wide[] = {'o', 0x159, 0x20ac, 0};
    check("text is turned by 8 arguments",
          WideCharToMultiByte(windows::kUtf8, 0, wide, -1, text, 9, nullptr, nullptr) == 7);
    check("... rightly", __builtin_memcmp(text, "o\xc5\x99\xe2\x82\xac", 7) == 0);
}

} // namespace probe

// Starts programs as Windows starts them: with closed standard handles, from a console or without one.
#include "probe.h"

#include "host/files.h"
#include "host/process.h"

using namespace odraz;

namespace probe {

namespace {

struct Startup {
    uint32_t size, pad;
    uint64_t names[3];
    uint32_t window[7], flags;
    uint64_t more[2];
    HANDLE standard[3];
};
static_assert(sizeof(Startup) == 104 && offsetof(Startup, flags) == 60);
struct Started {
    HANDLE process, thread;
    uint32_t ids[2];
};

// Returns the program's status, or 125 if it did not start. DETACHED_PROCESS (8) leaves it without a console:
// Wine would give every program a new one.
uint32_t run(const char *line, HANDLE standard[3]) {
    static WCHAR wide[32768];
    MultiByteToWideChar(windows::kUtf8, 0, line, -1, wide, 32768);
    Startup startup = {};
    startup.size = sizeof startup;
    startup.flags = 0x100; // standard handles are given
    auto inherit =
        (PROBE_WINDOWS int (*)(HANDLE, uint32_t, uint32_t))function("kernel32.dll", "SetHandleInformation");
    for (int i = 0; i < 3; ++i) {
        startup.standard[i] = standard[i];
        inherit(standard[i], 1, 1);
    }
    auto create =
        (PROBE_WINDOWS int (*)(const WCHAR *, WCHAR *, void *, void *, int, uint32_t, void *, const WCHAR *,
                               Startup *, Started *))function("kernel32.dll", "CreateProcessW");
    auto exit = (PROBE_WINDOWS int (*)(HANDLE, uint32_t *))function("kernel32.dll", "GetExitCodeProcess");
    Started started;
    if (!create(nullptr, wide, nullptr, nullptr, 1, 8, nullptr, nullptr, &startup, &started)) return 125;
    WaitForSingleObject(started.process, ~0u);
    uint32_t status = 125;
    exit(started.process, &status);
    return status;
}

void close(HANDLE standard[3], const char *how, const char *which) {
    for (; *which; ++which) {
        HANDLE &handle = standard[*which - '0'];
        if (*how == 's') CloseHandle(handle);
        if (*how != 's') handle = *how == 'n' ? nullptr : windows::kInvalid;
    }
}

} // namespace

uint32_t start(const char *how, const char *which, const char *line) {
    HANDLE standard[3];
    for (int i = 0; i < 3; ++i) standard[i] = windows::standard(i);
    close(standard, how, which);
    return run(line, standard);
}

uint32_t startInConsole(const char *which, const char *line) {
    HANDLE standard[3], own[3];
    for (int i = 0; i < 3; ++i) own[i] = standard[i] = windows::standard(i);
    close(standard, "null", which);
    auto allocate = (PROBE_WINDOWS int (*)())function("kernel32.dll", "AllocConsole");
    if (!allocate()) return 124;
    uint32_t status = run(line, standard);
    // Copy the rows of the screen that are not empty
    static const WCHAR kConsole[] = {'C', 'O', 'N', 'O', 'U', 'T', '$', 0};
    HANDLE screen = CreateFileW(kConsole, 0xc0000000, 3, nullptr, 3, 0, nullptr);
    auto read = (PROBE_WINDOWS int (*)(HANDLE, char *, uint32_t, uint32_t, uint32_t *))function(
        "kernel32.dll", "ReadConsoleOutputCharacterA");
    uint32_t got = 0;
    for (uint32_t row = 0; row < 25; ++row) {
        char text[82] = "|";
        if (!read(screen, text + 1, 80, row << 16, &got)) return 123;
        while (got && text[got] == ' ') --got;
        if (!got) continue;
        text[got + 1] = '\n';
        WriteFile(own[1], text, got + 2, &got, nullptr);
    }
    return status;
}

} // namespace probe

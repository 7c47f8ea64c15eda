// Error messages: on standard error or, if there is none, in a message box.
#include "film.h"
#include "host/clock.h"
#include "host/library.h"
#include "host/process.h"
#include "host/threads.h"
#include "host/windows/calls.h"

namespace odraz {

using namespace windows;

namespace {

// Ends the process after half a minute: a script must not wait for a box that nobody closes.
[[gnu::force_align_arg_pointer]] void *endLater(void *) {
    sleepFor(30000000000);
    endProcess(1);
}

int report(const char *line, bool box) {
    char text[512] = FILM_NAME ": ";
    uint32_t size = sizeof FILM_NAME + 1;
    // Keep the message to one line, even if it quotes control characters that a user gave
    for (; *line && size < 510; ++line) text[size++] = (uint8_t)*line < ' ' ? '?' : *line;
    text[size++] = '\n';
    // Consoles and boxes get UTF-16, because they do not read bytes as UTF-8
    WCHAR wide[513];
    int units = MultiByteToWideChar(kUtf8, 0, text, (int)size, wide, 512);
    wide[units] = 0;
    HANDLE to = standard(2);
    uint32_t mode;
    if (GetConsoleMode(to, &mode))
        WriteConsoleW(to, wide, (uint32_t)units, &mode, nullptr);
    else if (GetFileType(to))
        WriteFile(to, text, size, &size, nullptr);
    else if (box && !loadFunctions("user32.dll", ODRAZ_USER32(ODRAZ_NAME), odrazFunctions.user32) &&
             !startThread(endLater, nullptr))
        MessageBoxW(nullptr, wide, nullptr, 0x10 /* an error icon */);
    return 1;
}

} // namespace

// A script has at least standard output. If that is closed too, a viewer has started the film and gets a box.
int printError(const char *line) { return report(line, !GetFileType(standard(1))); }

int showError(const char *line) { return report(line, true); }

} // namespace odraz

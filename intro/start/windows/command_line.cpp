#include "start/windows/command_line.h"

#include "host/windows/windows.h"
#include "start/early.h"

namespace odraz {

static Arguments theArguments;
static char theText[3 * 32768]; // room for the longest command line, in UTF-8

Arguments &arguments() {
    Arguments &a = theArguments;
    if (a.count) return a;
    windows::begin();
    WideCharToMultiByte(windows::kUtf8, 0, GetCommandLineW(), -1, theText, sizeof theText, nullptr, nullptr);
    // Split in place: `to` never overtakes `from`
    char *from = theText, *to = theText;
    // If the line begins with a blank, the program's own name is empty
    do {
        a.values[a.count++] = to;
        for (bool quoted = false; *from && (quoted || (*from != ' ' && *from != '\t'));) {
            // Before a quotation mark, two backslashes mean one. A single one left over makes the mark an
            // ordinary character
            int slashes = 0;
            while (*from == '\\') ++from, ++slashes;
            bool quote = *from == '"';
            for (int n = quote ? slashes / 2 : slashes; n; --n) *to++ = '\\';
            if (quote && !(slashes & 1)) {
                quoted = !quoted;
                ++from;
            } else if (quote || !slashes) {
                *to++ = *from++;
            }
        }
        bool last = !*from;
        *to++ = 0;
        if (last) return a;
        do ++from;
        while (*from == ' ' || *from == '\t');
    } while (*from && a.count + 1 < (long)(sizeof a.values / sizeof *a.values));
    return a;
}

} // namespace odraz

// The packer's stub calls this instead of odrazEarly(), which expects argc and argv as on Linux's stack.
extern "C" void odrazEarlyWindows(void **, uint32_t done, uint32_t size) {
    odrazEarly((void **)&odraz::arguments(), done, size);
}

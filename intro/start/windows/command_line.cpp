#include "start/windows/command_line.h"

#include "host/windows/windows.h"
#include "start/early.h"

namespace odraz {

static CommandLine theCommandLine;
static char theText[3 * 32768]; // of the longest command line, in UTF-8

CommandLine &commandLine() {
    CommandLine &a = theCommandLine;
    if (a.count) return a;
    windows::begin();
    WideCharToMultiByte(windows::kUtf8, 0, GetCommandLineW(), -1, theText, sizeof theText, nullptr, nullptr);
    // In place: what is written is never longer than what was read
    char *from = theText, *to = theText;
    // If the line begins with a blank, the program's own name is empty
    do {
        a.values[a.count++] = to;
        for (bool quoted = false; *from && (quoted || (*from != ' ' && *from != '\t'));) {
            // Before a quotation mark, two backslashes stand for one; an odd one left over makes the mark an
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

// Called by the packer's stub in place of odrazEarly, which takes the arguments as they lie on Linux's stack.
extern "C" void odrazEarlyWindows(void **, uint32_t done, uint32_t size) {
    odrazEarly((void **)&odraz::commandLine(), done, size);
}

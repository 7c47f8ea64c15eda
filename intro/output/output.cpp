#include "output/output.h"

#include "host/files.h"
#include "host/process.h"
#include "options.h"

namespace odraz {

constexpr int kLongestName = 150; // characters

int cannotWrite(const char *what, const char *why) {
    // Print only the end of a long name, so that the line has room for the reason
    int length = 0;
    while (what[length]) ++length;
    Message m;
    m << "cannot write ";
    if (length > kLongestName) m << "...", what += length - kLongestName;
    m << what << ": " << why;
    return printError(m.data);
}

int checkOutput(const char *to, bool stdoutClosed) {
    if (!isStdout(to)) return 0;
    if (stdoutClosed) return cannotWrite("standard output", "it is closed");
    if (!isTerminal(1)) return 0;
    printError("refusing to write binary data to the terminal: redirect it");
    return 2;
}

int writeOutput(const char *to, const void *data, size_t size) {
    bool toStdout = isStdout(to);
    const char *wrong = toStdout ? writeAll(1, data, size) : writeFile(to, data, size);
    return wrong ? cannotWrite(toStdout ? "standard output" : to, wrong) : 0;
}

} // namespace odraz

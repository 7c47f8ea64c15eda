// Tests how the film splits command lines, which are written over this program's own. CommandLineToArgvW
// gives the expected result, except for doubled quotation marks in a quoted part, where Windows's own
// libraries disagree.
#include "probe.h"

#include "start/windows/command_line.h"

using namespace odraz;

namespace probe {

namespace {

WCHAR *theLine;
int theRoom; // of units, without the zero

bool put(const char16_t *text) {
    int n = 0;
    for (; text[n]; ++n) {
        if (n == theRoom) return false;
        theLine[n] = text[n];
    }
    theLine[n] = 0;
    return true;
}

CommandLine &split() {
    CommandLine &a = commandLine();
    a = {};
    return commandLine();
}

// Whether the line is split as Windows splits it.
bool asWindows() {
    static const auto reference =
        (PROBE_WINDOWS WCHAR * *(*)(const WCHAR *, int *)) function("shell32.dll", "CommandLineToArgvW");
    static char text[100000];
    int count = 0;
    WCHAR **values = reference(theLine, &count);
    CommandLine &a = split();
    bool good = values && a.count == count;
    for (int i = 0; good && i < count; ++i) {
        WideCharToMultiByte(windows::kUtf8, 0, values[i], -1, text, sizeof text, nullptr, nullptr);
        good = is(text, a.values[i]);
    }
    return good && !a.values[count];
}

bool splitsInto(const char *arguments) { // each with a '|' behind it
    CommandLine &a = split();
    for (int i = 0; i < a.count; ++i) {
        for (const char *p = a.values[i]; *p; ++p)
            if (*arguments++ != *p) return false;
        if (*arguments++ != '|') return false;
    }
    return !*arguments;
}

const struct {
    const char16_t *line;
    const char *arguments;
} kLines[] = {
    // Microsoft's own examples
    {u"p \"a b c\" d e", "p|a b c|d|e|"},
    {u"p \"ab\\\"c\" \"\\\\\" d", "p|ab\"c|\\|d|"},
    {u"p a\\\\\\b d\"e f\"g h", "p|a\\\\\\b|de fg|h|"},
    {u"p a\\\\\\\"b c d", "p|a\\\"b|c|d|"},
    {u"p a\\\\\\\\\"b c\" d e", "p|a\\\\b c|d|e|"},
    // Blanks
    {u"p", "p|"},
    {u"p ", "p|"},
    {u"p   \t ", "p|"},
    {u"p \t a\t\tb ", "p|a|b|"},
    {u" a b", "|a|b|"}, // the program's own name is empty then
    {u"p a\nb", "p|a\nb|"},
    // Quotation marks
    {u"p \"\"", "p||"},
    {u"p \"\" a \"\"", "p||a||"},
    {u"p a\"\" b", "p|a|b|"},
    {u"p \"a", "p|a|"},
    {u"p \"a b  ", "p|a b  |"},
    {u"p \"", "p||"},
    {u"p \"a\"b\"c d\"", "p|abc d|"},
    {u"\"C:\\Program Files\\p.exe\" --to 1", "C:\\Program Files\\p.exe|--to|1|"},
    // Backslashes
    {u"p \\", "p|\\|"},
    {u"p \\\\", "p|\\\\|"},
    {u"p \\\"", "p|\"|"},
    {u"p \\\\\" a\"", "p|\\ a|"},
    {u"p \"C:\\a b\\\\\" c", "p|C:\\a b\\|c|"},
    {u"p \"C:\\a b\\\" c", "p|C:\\a b\" c|"},
    {u"p \\\\host\\share\\x", "p|\\\\host\\share\\x|"},
    {u"p \\a\\ \\b", "p|\\a\\|\\b|"},
    // Characters outside ASCII
    {u"p \u017elu\u0165 \u20ac\"\u00a0\" \U0001f3b5",
     "p|\xc5\xbelu\xc5\xa5|\xe2\x82\xac\xc2\xa0|\xf0\x9f\x8e\xb5|"},
};

} // namespace

void arguments() {
    theLine = (WCHAR *)GetCommandLineW();
    while (theLine[theRoom]) ++theRoom;
    check("there is room to write into", theRoom > 30000, theRoom);
    if (theRoom <= 30000) return;

    int n = 0, wrong = 0;
    for (auto &[line, arguments] : kLines) {
        put(line);
        if (!splitsInto(arguments)) check("split as meant", false, n), ++wrong;
        if (!asWindows()) check("split as by CommandLineToArgvW", false, n), ++wrong;
        ++n;
    }
    check("odd command lines are split as Windows does", !wrong, wrong);

    // Random lines of special characters
    uint32_t random = 1;
    wrong = 0;
    for (int line = 0; line < 5000; ++line) {
        theLine[0] = 'p', theLine[1] = ' ';
        int at = 2;
        for (int size = line % 40; at < 2 + size; ++at) {
            random = random * 1664525 + 1013904223;
            theLine[at] = (WCHAR) "a \\\"\\\tb\\"[random >> 29];
            if (theLine[at] == '"' && theLine[at - 1] == '"') theLine[at] = 'c';
        }
        theLine[at] = 0;
        if (!asWindows() && !wrong++) check("a line by chance is split as Windows does", false, line);
    }
    check("5000 others, too", !wrong, wrong);

    // The largest number and length of arguments
    for (int i = 0; i < 30000; ++i) theLine[i] = i % 2 ? ' ' : 'x';
    theLine[30000] = 0;
    CommandLine &many = split();
    check("what is beyond the last is left out", many.count == 511 && !many.values[511], many.count);
    for (int i = 0; i < 30000; ++i) theLine[i] = 0x20ac;
    theLine[1] = ' ';
    check("a line of 90 KB as text is whole", asWindows());
    put(u"");
    check("without any, nothing is wrong", split().count <= 1, split().count);
}

} // namespace probe

// Tests how the film splits the command line of Windows. The functions of Windows are replaced by those
// below.
#include "start/windows/command_line.h"

#include "host/windows/windows.h"

using namespace odraz;

static std::string theLine; // in UTF-8, as after the conversion by Windows

// Returns the arguments, each followed by a '|'.
static std::string split(const std::string &line) {
    theLine = line;
    Arguments &a = arguments();
    a = {};
    arguments();
    EXPECT_EQ(a.values[a.count], nullptr);
    std::string all;
    for (int i = 0; i < a.count; ++i) all += a.values[i] + std::string("|");
    return all;
}

void windows::begin() {}
const WCHAR *GetCommandLineW() { return nullptr; }
int WideCharToMultiByte(uint32_t, uint32_t, const WCHAR *, int, char *to, int room, const char *, int *) {
    std::snprintf(to, (size_t)room, "%s", theLine.c_str());
    return (int)theLine.size() + 1;
}
extern "C" void odrazEarly(void **, uint32_t, uint32_t) {}

// It splits as CommandLineToArgvW does, except for doubled quotation marks in a quoted part, where Windows's
// own libraries disagree.
TEST(CommandLine, IsSplitAsWindowsDoes) {
    const struct {
        const char *line, *arguments;
    } kLines[] = {
        // Microsoft's own examples
        {R"(p "a b c" d e)", "p|a b c|d|e|"},
        {R"(p "ab\"c" "\\" d)", R"(p|ab"c|\|d|)"},
        {R"(p a\\\b d"e f"g h)", R"(p|a\\\b|de fg|h|)"},
        {R"(p a\\\"b c d)", R"(p|a\"b|c|d|)"},
        {R"(p a\\\\"b c" d e)", R"(p|a\\b c|d|e|)"},
        // Blanks
        {"p", "p|"},
        {"p ", "p|"},
        {"p   \t ", "p|"},
        {"p \t a\t\tb ", "p|a|b|"},
        {" a b", "|a|b|"}, // the program's own name is empty then
        {"p a\nb", "p|a\nb|"},
        // Quotation marks
        {R"(p "")", "p||"},
        {R"(p "" a "")", "p||a||"},
        {R"(p a"" b)", "p|a|b|"},
        {R"(p "a)", "p|a|"},
        {R"(p "a b  )", "p|a b  |"},
        {R"(p ")", "p||"},
        {R"(p "a"b"c d")", "p|abc d|"},
        {R"("C:\Program Files\p.exe" --to 1)", R"(C:\Program Files\p.exe|--to|1|)"},
        // Backslashes
        {R"(p \)", R"(p|\|)"},
        {R"(p \\)", R"(p|\\|)"},
        {R"(p \")", R"(p|"|)"},
        {R"(p \\" a")", R"(p|\ a|)"},
        {R"(p "C:\a b\\" c)", R"(p|C:\a b\|c|)"},
        {R"(p "C:\a b\" c)", R"(p|C:\a b" c|)"},
        {R"(p \\host\share\x)", R"(p|\\host\share\x|)"},
        {R"(p \a\ \b)", R"(p|\a\|\b|)"},
        // Characters outside ASCII
        {"p žluť €\"\u00a0\" 🎵", "p|žluť|€\u00a0|🎵|"},
    };
    for (auto &[line, arguments] : kLines) EXPECT_EQ(split(line), arguments) << line;
}

TEST(CommandLine, LeavesOutWhatIsBeyondTheLast) {
    std::string many;
    for (int i = 0; i < 15000; ++i) many += "x ";
    split(many);
    EXPECT_EQ(arguments().count, 511);
    EXPECT_LE((split(""), arguments().count), 1);
}

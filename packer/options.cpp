#include "packer/options.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>

namespace pack {
namespace {

constexpr char kUsage[] =
    "usage: pack IN -o OUT [OPTION...]       pack a program: any for x86-64 Linux, as compilers make them, "
    "or\n"
    "                                        for fewer bytes one that was made for it (packer/README.md)\n"
    "       pack --test FILE                 decode a packed file and say whether it is whole\n"
    "       pack -d FILE -o OUT              write the program of a packed file, not packed\n"
    "--loader                      pack as any program, even if IN was made for packing\n"
    "--pe                          write OUT for Windows; IN must be linked for it\n"
    "--plain                       do not pack: write OUT with the program as it lies in memory\n"
    "--budget BYTES|none           write OUT only if it has at most so many bytes; 65536 for a program\n"
    "                              made for packing, else none\n"
    "--fast                        use few contexts: 10 % larger, starts in less than half the time\n"
    "--effort fast|normal|best|SECONDS\n"
    "                              search so long for contexts that suit the program: not at all, 30 s,\n"
    "                              15 minutes, or SECONDS; fast\n"
    "--model FILE                  start with the contexts in FILE instead of ordinary ones\n"
    "--save-model FILE             write the contexts that were used to FILE\n"
    "--name NAME                   what the packed program calls itself when it cannot start; up to 10\n"
    "                              letters\n"
    "--safe-name NAME              the same program, not packed: it is named where nothing that was written\n"
    "                              may run; up to 14 letters\n"
    "--map FILE                    print what each object file costs, by the linker's map in FILE\n"
    "--symbols FILE                with --map, of a program linked with -flto: what `nm -A` prints of its "
    "object files\n"
    "--report FILE                 write to FILE, as JSON, what each section, object file and symbol costs\n"
    "--html FILE                   write to FILE a page that shows it: every byte, treemap, tables, budget\n"
    "--text FILE                   write to FILE, for a comment on a change, the size and the ten largest "
    "changes;\n"
    "                              with - print that and nothing else\n"
    "--than OLD.json               with --html or --text, compare with an earlier --report\n"
    "--rooms FILE                  with --map, group object files as FILE says, a line each: ROOM SHARE "
    "OBJECT...,\n"
    "                              the share in bytes or -; otherwise by their archives and folders\n";

bool parseNumber(const char *text, double &value) {
    char *end;
    value = std::strtod(text, &end);
    return end != text && !*end && value >= 0 && value < 1e9;
}

// Takes an option that is followed by a file's name; false if `word` is none.
bool takeFile(Options &o, const std::string &word, const char *file) {
    struct {
        const char *name, **value;
        bool onlyToPack;
    } options[] = {{"-o", &o.out, false},
                   {"--test", &o.test, false},
                   {"-d", &o.unpack, false},
                   {"--model", &o.model, true},
                   {"--save-model", &o.saveModel, true},
                   {"--map", &o.map, true},
                   {"--symbols", &o.symbols, true},
                   {"--report", &o.report, true},
                   {"--html", &o.html, true},
                   {"--text", &o.text, true},
                   {"--than", &o.than, true},
                   {"--rooms", &o.rooms, true}};
    for (auto &option : options)
        if (word == option.name && file && !*option.value) {
            *option.value = file;
            if (option.onlyToPack) o.onlyToPack = option.name;
            return true;
        }
    return false;
}

long budgetOf(const char *text) {
    double number;
    if (!std::strcmp(text, "none")) return kNoBudget;
    if (!parseNumber(text, number) || number != (long)number)
        throw Refusal{std::string("--budget needs a number of bytes, or none, not '") + text + "'", 2};
    return (long)number;
}

double secondsOf(const std::string &effort) {
    double number;
    if (!parseNumber(effort.c_str(), number))
        number = effort == "fast" ? 0 : effort == "normal" ? 30 : effort == "best" ? 900 : -1;
    if (number < 0)
        throw Refusal{"--effort needs fast, normal, best or a number of seconds, not '" + effort + "'", 2};
    return number;
}

// Nothing is written over what is read, or over what is written, too; but a model may be replaced by the one
// that was found, and a report by the new one.
void checkPaths(const Options &o) {
    const char *outputs[] = {o.out, o.report, o.html, o.text, o.saveModel},
               *inputs[] = {o.in, o.unpack, o.map, o.symbols, o.rooms};
    auto same = [](const char *a, const char *b) {
        std::error_code ignored;
        return a && b && std::strcmp(a, "-") &&
               std::filesystem::weakly_canonical(a, ignored) ==
                   std::filesystem::weakly_canonical(b, ignored) &&
               !std::filesystem::is_character_file(a, ignored);
    };
    for (size_t i = 0; i < std::size(outputs); ++i) {
        for (const char *input : inputs)
            if (same(outputs[i], input))
                throw Refusal{std::string(input) + " would be written over: give another name", 2};
        for (size_t k = 0; k < i; ++k)
            if (same(outputs[i], outputs[k]))
                throw Refusal{std::string(outputs[i]) + " is to be two files: give another name", 2};
    }
}

// One and only one of the three things that pack does must be asked for.
void checkModes(const Options &o) {
    int modes = (o.in != nullptr) + (o.test != nullptr) + (o.unpack != nullptr);
    if (modes != 1 || !o.out != (o.test != nullptr))
        throw Refusal{"it takes IN -o OUT, or --test FILE, or -d FILE -o OUT; see pack --help", 2};
    if (!o.in && o.onlyToPack)
        throw Refusal{std::string(o.onlyToPack) + " is for packing alone; see pack --help", 2};
    checkPaths(o);
    if (o.than && !o.html && !o.text) throw Refusal{"--than needs --html or --text; see pack --help", 2};
    if (o.symbols && !o.map) throw Refusal{"--symbols needs --map; see pack --help", 2};
    if (o.rooms && !o.map) throw Refusal{"--rooms needs --map; see pack --help", 2};
}

} // namespace

Options parseOptions(int argc, char **argv) {
    Options o;
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        const char *next = i + 1 < argc ? argv[i + 1] : nullptr;
        if (takeFile(o, word, next))
            ++i;
        else if (word == "--help") {
            std::fputs(kUsage, stdout);
            std::exit(0);
        } else if (word == "--pe") {
            o.pe = true;
            o.onlyToPack = "--pe";
        } else if (word == "--loader") {
            o.loader = true;
            o.onlyToPack = "--loader";
        } else if (word == "--plain") {
            o.plain = true;
            o.onlyToPack = "--plain";
        } else if (word == "--fast") {
            o.fast = true;
            o.onlyToPack = "--fast";
        } else if ((word == "--name" || word == "--safe-name") && next) {
            (word == "--name" ? o.names.program : o.names.safe) = argv[++i];
            o.onlyToPack = word == "--name" ? "--name" : "--safe-name";
        } else if (word == "--budget" && next) {
            o.budget = budgetOf(argv[++i]);
            o.onlyToPack = "--budget";
        } else if (word == "--effort" && next) {
            o.seconds = secondsOf(argv[++i]);
            o.onlyToPack = "--effort";
        } else if (argv[i][0] != '-' && !o.in)
            o.in = argv[i];
        else
            throw Refusal{"cannot use '" + word + "'; see pack --help", 2};
    }
    if (o.fast && o.model) throw Refusal{"--fast and --model both choose contexts; see pack --help", 2};
    if (o.pe && o.loader) throw Refusal{"--loader is for Linux, --pe for Windows; see pack --help", 2};
    checkModes(o);
    return o;
}

} // namespace pack

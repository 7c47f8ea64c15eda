#include "packer/options.h"

#include "packer/model/model_parameters.h"
#include "tools/common/whole_file.h"

namespace pack {

namespace {

constexpr double kMostNumber = 1e9;

long budgetOf(const std::string &text) {
    if (text == "none") return kNoBudget;
    try {
        double bytes = common::numberOf("--budget", text, {0, kMostNumber});
        if (bytes == (double)(long)bytes) return (long)bytes;
    } catch (const common::Refused &) {
    }
    throw common::Refused("--budget needs a number of bytes, or none, not '" + text + "'");
}

double secondsOf(const std::string &effort) {
    if (effort == "fast") return 0;
    if (effort == "normal") return 30;
    if (effort == "best") return 900;
    try {
        return common::numberOf("--effort", effort, {0, kMostNumber});
    } catch (const common::Refused &) {
        throw common::Refused("--effort needs fast, normal, best or a number of seconds, not '" + effort +
                              "'");
    }
}

// Refuses an output that would replace an input or another output. There are two exceptions: the saved model
// may replace the given model, and the report may replace the earlier report.
void claimFiles(const PackOptions &o) {
    for (const std::string &input : {o.in, o.unpack, o.map, o.symbols, o.rooms})
        if (!input.empty()) common::noteInput(input);
    for (auto [output, old] : {std::pair<std::string, std::string>{o.out, ""},
                               {o.report, o.than},
                               {o.html, ""},
                               {o.text, ""},
                               {o.saveModel, o.modelFile}})
        if (!output.empty() && output != "-") common::claimOutput(output, old);
}

void check(const common::CommandLine &line, PackOptions &o) {
    if (o.fast && !o.modelFile.empty()) line.refuse("--fast and --model both choose contexts");
    if (o.pe && o.loader) line.refuse("--loader is for Linux, --pe for Windows");
    int modes = !o.in.empty() + !o.test.empty() + !o.unpack.empty();
    if (modes != 1 || o.out.empty() != !o.test.empty())
        line.refuse("it takes IN -o OUT, or --test FILE, or -d FILE -o OUT");
    for (const std::string &given : line.given())
        if (o.in.empty() && given != "-o" && given != "-d" && given != "--test")
            line.refuse(given + " is only for packing");
    if (o.map.empty() && !o.symbols.empty()) line.refuse("--symbols needs --map");
    if (o.map.empty() && !o.rooms.empty()) line.refuse("--rooms needs --map");
    if (!o.than.empty() && o.html.empty() && o.text.empty()) line.refuse("--than needs --html or --text");
    claimFiles(o);
    if (!o.modelFile.empty()) o.model = readParameters(o.modelFile);
}

} // namespace

PackOptions parseOptions(common::CommandLine &line) {
    PackOptions o;
    line.about(
        "Packs a program for x86-64 Linux into a smaller one that unpacks itself: any program, and in\n"
        "fewer bytes one that was made for it (packer/README.md).\n"
        "  pack IN -o OUT [OPTION...]   packs\n"
        "  pack --test FILE             decodes a packed file and checks that it is whole\n"
        "  pack -d FILE -o OUT          writes the program of a packed file, not packed");
    line.argument("IN", o.in, "the program to pack", false);
    line.option("-o", "OUT", o.out, "the file to write");
    line.option("--test", "FILE", o.test, "a packed file to check");
    line.option("-d", "FILE", o.unpack, "a packed file to unpack");
    line.group("How to pack");
    line.flag("--loader", o.loader, "pack as any program, even if IN was made for packing");
    line.flag("--pe", o.pe,
              "write OUT for Windows; IN must be linked for it. Zeros fill OUT up to a multiple of 512 "
              "bytes; all others are the bytes used");
    line.flag("--plain", o.plain, "do not pack: write OUT with the program's memory image");
    line.flag("--fast", o.fast, "use few contexts: 10 % larger, starts in less than half the time");
    line.option(
        "--budget", "BYTES|none", [&](const std::string &text) { o.budget = budgetOf(text); },
        "if OUT would have more than BYTES, do not write it, and remove an earlier OUT; 65536 for a program "
        "made for packing, otherwise none");
    line.option(
        "--effort", "fast|normal|best|SECONDS", [&](const std::string &text) { o.seconds = secondsOf(text); },
        "how long to search for better contexts: not at all, 30 s, 15 minutes, or SECONDS; fast if not "
        "given");
    line.option("--model", "FILE", o.modelFile,
                "start with the contexts in FILE instead of the default ones");
    line.option("--save-model", "FILE", o.saveModel, "write the contexts that were used to FILE");
    line.option(
        "--safe-name", "NAME", o.safeName,
        "the name of the same program, not packed, for users whose system forbids packed programs; up to "
        "14 letters");
    line.group("What each part costs");
    line.option("--report", "FILE", o.report,
                "write the cost of each section, object file and symbol to FILE, as JSON");
    line.option("--html", "FILE", o.html,
                "write a page that shows the costs to FILE: every byte, treemap, tables, budget");
    line.option(
        "--text", "FILE", o.text,
        "write the size and the ten largest changes to FILE, for a comment on a change; with - print only "
        "that");
    line.option("--than", "OLD.json", o.than,
                "with --html or --text, compare with an earlier --report; if it does not exist yet, pack "
                "prints a note");
    line.option("--map", "FILE", o.map, "print the cost of each object file, by the linker's map in FILE");
    line.option("--symbols", "FILE", o.symbols,
                "with --map, for a program linked with -flto: the output of `nm -A` for its object files");
    line.option(
        "--rooms", "FILE", o.rooms,
        "with --map, group object files by the lines of FILE: ROOM SHARE OBJECT..., the share in bytes or "
        "-; otherwise by archives and folders");
    line.parse();
    check(line, o);
    return o;
}

} // namespace pack

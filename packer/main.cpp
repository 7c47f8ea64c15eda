// pack: makes a small self-unpacking executable out of a program, and unpacks it again.
#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/options.h"
#include "packer/report/report_html.h"
#include "packer/write/packed_file.h"

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace pack {

namespace {

constexpr long kUsualBudget = 65536; // bytes, for programs made for packing

volatile std::sig_atomic_t theInterruption;

std::string nameOf(const std::string &path) { return std::filesystem::path(path).filename(); }

ModelParameters findParameters(const PackOptions &o, const Program &program) {
    ModelParameters parameters = o.model.value_or(o.fast ? fastParameters() : defaultParameters());
    if (o.seconds <= 0) return parameters;
    double shown = -1e9;
    bool terminal = isatty(2);
    // Ctrl-C ends only the search
    std::signal(SIGINT, [](int) { theInterruption = 1; });
    auto show = [&](const Progress &p) {
        if (p.seconds < shown + (terminal ? 0.5 : 20)) return !theInterruption;
        shown = p.seconds;
        std::fprintf(stderr, "%ssearching: %.0f bytes after %d tries, %.0f of %.0f s%s", terminal ? "\r" : "",
                     p.bytes, p.tried, p.seconds, o.seconds, terminal ? "" : "\n");
        return !theInterruption;
    };
    Layout layout = program.layout();
    parameters = search(program.bytes, layout, parameters, o.seconds, show);
    if (terminal) std::fputc('\n', stderr);
    return parameters;
}

// Refuses packed programs, and programs whose packed copy would lose special rights.
void checkCopy(const std::string &path, const Bytes &file) {
    struct stat s;
    need(stat(path.c_str(), &s) == 0 && !(s.st_mode & (S_ISUID | S_ISGID)),
         "it is setuid or setgid, which a packed file cannot be: pack a copy without that (chmod a-s)");
    need(!isPacked(kElf, file) && !isPacked(kLoader, file),
         "it is packed already: pack the original program");
    need(getxattr(path.c_str(), "security.capability", nullptr, 0) < 0,
         "it has file capabilities, which a packed file cannot have: pack a copy without them (cp)");
}

// Warns about properties of a packed file that a user might not expect.
void warn(const PackOptions &o, const Program &program, uint64_t appended, double seconds) {
    constexpr size_t kLarge = 2 << 20;
    if (appended)
        std::printf("%s: %llu bytes appended to the program are left out: if it reads them from its own "
                    "file, it will not work\n",
                    o.out.c_str(), (unsigned long long)appended);
    if (program.bytes.size() > kLarge)
        std::printf("%s: unpacking takes about %.0f s at every start, on a processor like this one%s\n",
                    o.out.c_str(), seconds, o.fast || o.model ? "" : "; less with --fast");
}

// The other inputs of the reports. They are read and checked before packing, which may take minutes.
struct ReportInputs {
    std::string map, symbols;
    std::optional<Rooms> rooms;
    std::optional<Report> before;

    explicit ReportInputs(const PackOptions &o) {
        if (!o.map.empty()) map = common::readWhole(o.map);
        if (!o.map.empty() && !isMap(map))
            throw common::Refused(o.map + ": not a linker map of GNU ld: link with -Wl,-Map=FILE");
        if (!o.symbols.empty()) symbols = common::readWhole(o.symbols);
        if (!o.rooms.empty()) rooms = common::parseFile(o.rooms, readRooms);
        if (std::error_code none; !o.than.empty() && std::filesystem::exists(o.than, none))
            before = common::parseFile(o.than, readJson);
    }
};

// Prints and writes the reports. `before` gets the rooms of `report`.
void writeReports(const PackOptions &o, const Report &report, const Program &program, long budget,
                  std::optional<Report> &before) {
    if (before) arrange(*before, report);
    const Report *old = before ? &*before : nullptr;
    std::string name = nameOf(o.out);
    std::string text = o.text.empty() ? "" : printMarkdown(name, report, old, budget);
    std::fputs((o.text == "-" ? text : printReport(report)).c_str(), stdout);
    if (!o.report.empty()) common::writeWhole(o.report, printJson(report));
    if (!o.text.empty() && o.text != "-") common::writeWhole(o.text, text);
    if (!o.html.empty())
        common::writeWhole(o.html, printHtml({name, o.in, budget, old, nameOf(o.than)}, report, program));
}

// Packs o.in to o.out: searches, packs, verifies, reports. SIGINT during a search ends only the search.
// Throws std::runtime_error if the packed file is over budget.
void packProgram(const PackOptions &o) {
    Bytes file = readBytes(o.in);
    unsigned mode = modeOf(o.in);
    bool any = o.loader || (!o.pe && !isMadeForPacking(file));
    const PackedKind &kind = any ? kLoader : o.pe ? kPe : kElf;
    Program program = common::inFile(o.in, [&] {
        checkCopy(o.in, file);
        checkSafeName(o.safeName);
        return any ? readAnyProgram(file) : readProgram(file, o.pe ? kWindows : kLinux);
    });
    if (o.plain) return common::inFile(o.in, [&] { writeBytes(o.out, kind.writePlain(program), mode); });
    ReportInputs given(o);
    ModelParameters parameters = findParameters(o, program);
    auto [packed, stretches] = common::inFile(o.in, [&] {
        return std::pair(makePacked(kind, program, parameters, o.safeName),
                         attribute(file, given.map, given.symbols, program));
    });

    std::error_code none;
    auto before = std::filesystem::file_size(o.out, none);
    long budget = o.budget.value_or(any ? kNoBudget : kUsualBudget);
    Report report = makeReport(std::move(stretches), packed.bits, packed.used, packed.overhead,
                               given.rooms ? &*given.rooms : nullptr);
    writeReports(o, report, program, budget, given.before);
    if (!o.saveModel.empty())
        common::writeWhole(o.saveModel, "# contexts for " + nameOf(o.in) + ", found by pack --effort\n" +
                                            printParameters(parameters));
    checkBudget(o.out, packed, budget);
    writeBytes(o.out, packed.bytes, mode);
    if (!o.than.empty() && !given.before)
        std::fprintf(stderr, "pack: there is no %s yet, so nothing is compared: write it with --report\n",
                     o.than.c_str());
    if (o.text == "-") return;
    std::printf("%s: %s (%zu of them stub and headers) from %zu in memory", o.out.c_str(),
                sizeText(packed).c_str(), packed.overhead, program.bytes.size());
    if (!none) std::printf(", before %ld (%+ld)", (long)before, (long)packed.bytes.size() - (long)before);
    if (budget >= 0) std::printf(", %ld bytes left of %ld", budget - (long)packed.used, budget);
    std::puts("");
    if (any) warn(o, program, appendedBytes(file), packed.seconds);
}

void openPackedFile(const PackOptions &o, const std::string &path, const Bytes &file) {
    const PackedKind &kind = kindOf(file);
    Program program = readPacked(kind, file);
    if (o.test.empty())
        writeBytes(o.out, kind.writePlain(program), modeOf(path));
    else
        std::printf("%s: whole; %zu bytes of a program that takes %u in memory\n", path.c_str(),
                    program.bytes.size(), program.span);
}

int runPack(common::CommandLine &line) {
    PackOptions o = parseOptions(line);
    std::string path = o.test + o.unpack;
    if (path.empty()) {
        packProgram(o);
        return 0;
    }
    Bytes file = readBytes(path);
    common::inFile(path, [&] { openPackedFile(o, path, file); });
    return 0;
}

} // namespace

} // namespace pack

int main(int argc, char **argv) { return common::runProgram("pack", argc, argv, pack::runPack); }

// pack: makes a small self-unpacking executable out of another, and takes it apart again.
#include "packer/files.h"
#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/options.h"
#include "packer/read/elf_reader.h"
#include "packer/read/loader_reader.h"
#include "packer/report/report_html.h"
#include "packer/write/elf_writer.h"
#include "packer/write/loader_writer.h"
#include "packer/write/pe_writer.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <optional>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace {

using pack::kNoBudget;
using pack::kUsualBudget;
using pack::Options;
using pack::Refusal;

constexpr long kBudget = 65536; // of a program made for packing

std::vector<uint8_t> read(const char *path) {
    std::vector<uint8_t> bytes;
    // A device may never end, and a pipe waits for a writer: take regular files only
    struct stat s;
    if (stat(path, &s) == 0 && !S_ISREG(s.st_mode))
        throw Refusal{std::string("cannot read ") + path + ": it is not a regular file", 2};
    if (!pack::readFile(path, bytes))
        throw Refusal{std::string("cannot read ") + path + ": " + std::strerror(errno), 2};
    return bytes;
}
std::string readText(const char *path) {
    std::vector<uint8_t> bytes = read(path);
    return {bytes.begin(), bytes.end()};
}
void write(const char *path, const void *bytes, size_t size, bool executable) {
    if (!pack::writeFile(path, bytes, size, executable))
        throw Refusal{std::string("cannot write ") + path + ": " + std::strerror(errno), 2};
}
void write(const char *path, const std::string &text) { write(path, text.data(), text.size(), false); }

volatile std::sig_atomic_t theInterruption;

pack::ModelParameters findParameters(const Options &o, const pack::Program &program) {
    pack::ModelParameters parameters = o.fast ? pack::fastParameters() : pack::defaultParameters();
    if (o.model) {
        std::string wrong = pack::parseParameters(readText(o.model), parameters);
        if (!wrong.empty()) throw Refusal{std::string(o.model) + ": " + wrong, 2};
    }
    if (o.seconds <= 0) return parameters;
    double shown = -1e9;
    bool terminal = isatty(2);
    // Ctrl-C ends the search, not the packing
    std::signal(SIGINT, [](int) { theInterruption = 1; });
    auto show = [&](const pack::Progress &p) {
        if (p.seconds < shown + (terminal ? 0.5 : 20)) return !theInterruption;
        shown = p.seconds;
        std::fprintf(stderr, "%ssearching: %.0f bytes after %d tries, %.0f of %.0f s%s", terminal ? "\r" : "",
                     p.bytes, p.tried, p.seconds, o.seconds, terminal ? "" : "\n");
        return !theInterruption;
    };
    pack::Layout layout = program.layout();
    parameters = pack::search(pack::filter(program.bytes, layout), layout, parameters, o.seconds, show);
    if (terminal) std::fputc('\n', stderr);
    return parameters;
}

// The ways to pack a program, and what each does in its own way.
struct Way {
    std::vector<uint8_t> (*write)(const pack::Program &, const pack::ModelParameters &,
                                  const std::vector<uint8_t> &payload, const pack::Names &);
    std::vector<uint8_t> (*decodeWithStub)(const std::vector<uint8_t> &packed);
    pack::Program (*read)(const std::vector<uint8_t> &packed);
    size_t (*overhead)(const pack::ModelParameters &);
    std::vector<uint8_t> (*plain)(const pack::Program &);
};
constexpr Way kMadeForIt = {pack::writePacked, pack::decodeWithStub, pack::readPacked, pack::overhead,
                            pack::writePlain},
              kPe = {pack::writePackedPe, pack::decodeWithStubPe, pack::readPackedPe, pack::overheadPe,
                     pack::writePlainPe},
              kLoader = {pack::writePackedLoader, pack::decodeWithStubLoader, pack::readPackedLoader,
                         pack::overheadLoader, pack::writePlainLoader};

// What a packed copy would not be, though it would run.
void checkCopy(const char *path, const std::vector<uint8_t> &file) {
    struct stat s;
    pack::need(stat(path, &s) == 0 && !(s.st_mode & (S_ISUID | S_ISGID)),
               "setuid or setgid, which a packed file cannot be: pack a copy without that (chmod a-s)");
    pack::need(!pack::isPacked(file) && !pack::isPackedLoader(file),
               "it is packed already: pack the program that it was made from");
    pack::need(getxattr(path, "security.capability", nullptr, 0) < 0,
               "it has file capabilities, which a packed file cannot have: pack a copy without them (cp)");
}

// What a user might not expect of a packed file.
void warn(const Options &o, const pack::Program &program, uint64_t appended, double seconds) {
    constexpr size_t kLarge = 2 << 20;
    if (appended)
        std::printf(
            "%s: %llu bytes that are appended to the program are left out; one that reads its own file "
            "will miss them\n",
            o.out, (unsigned long long)appended);
    if (program.bytes.size() > kLarge)
        std::printf("%s: unpacks for some %.0f s whenever it starts, on a processor like this one%s\n", o.out,
                    seconds, o.fast || o.model ? "" : "; --fast is for that");
}

// What the reports need besides the program, read before the packing, which may take long.
struct ForReports {
    std::string map, symbols;
    std::optional<pack::Rooms> rooms;
    std::optional<pack::Report> before;

    explicit ForReports(const Options &o) {
        if (o.map) map = readText(o.map);
        if (o.map && !pack::isMap(map))
            throw Refusal{std::string(o.map) + ": not a map of GNU ld: link with -Wl,-Map=FILE", 2};
        if (o.symbols) symbols = readText(o.symbols);
        if (o.rooms) rooms = parsed(o.rooms, pack::readRooms);
        if (o.than) before = parsed(o.than, pack::readJson);
        for (const char *path : {o.out, o.report, o.html, o.text, o.saveModel})
            if (path && std::strcmp(path, "-") && !pack::canWrite(path))
                throw Refusal{std::string("cannot write ") + path + ": " + std::strerror(errno), 2};
    }

private:
    template <class T> static T parsed(const char *path, T (*parse)(const std::string &)) {
        try {
            return parse(readText(path));
        } catch (const pack::Unsuitable &e) {
            throw Refusal{std::string(path) + ": " + e.what(), 2};
        }
    }
};

std::string lastName(const char *path) {
    std::string whole = path;
    return whole.substr(whole.rfind('/') + 1);
}

// `before` gets the rooms of `report`.
void writeReports(const Options &o, const pack::Report &report, const pack::Program &program, long budget,
                  std::optional<pack::Report> &before) {
    if (before) pack::arrange(*before, report);
    const pack::Report *old = before ? &*before : nullptr;
    bool alone = o.text && !std::strcmp(o.text, "-");
    std::string name = lastName(o.out);
    std::string text = o.text ? pack::printMarkdown(name, report, old, budget) : "";
    std::fputs((alone ? text : pack::printReport(report)).c_str(), stdout);
    if (o.report) write(o.report, pack::printJson(report));
    if (o.text && !alone) write(o.text, text);
    if (o.html)
        write(o.html,
              pack::printHtml({name, o.in, budget, old, o.than ? lastName(o.than) : ""}, report, program));
}

void makePacked(const Options &o) {
    std::vector<uint8_t> file = read(o.in);
    checkCopy(o.in, file);
    pack::checkNames(o.names);
    bool any = o.loader || (!o.pe && !pack::isMadeForPacking(file));
    const Way &way = any ? kLoader : o.pe ? kPe : kMadeForIt;
    pack::Program program =
        any ? pack::readAnyProgram(file) : pack::readProgram(file, o.pe ? pack::kWindows : pack::kLinux);
    if (o.plain) {
        std::vector<uint8_t> plain = way.plain(program);
        return write(o.out, plain.data(), plain.size(), true);
    }
    ForReports given(o);
    pack::ModelParameters parameters = findParameters(o, program);

    // Encode, and prove that both decoders give the program back
    pack::Workspace workspace;
    pack::Layout layout = program.layout();
    pack::Encoded encoded = pack::encode(program.bytes, layout, parameters, workspace);
    std::vector<uint8_t> packed = way.write(program, parameters, encoded.payload, o.names);
    size_t overhead = way.overhead(parameters);
    std::clock_t began = std::clock();
    bool same = way.decodeWithStub(packed) == program.bytes;
    double seconds = (double)(std::clock() - began) / CLOCKS_PER_SEC; // as when it starts
    if (!same || way.read(packed).bytes != program.bytes)
        throw Refusal{"the packed bytes do not decode to the program; nothing was written", 3};

    long size = (long)packed.size(), before = pack::fileSize(o.out);
    long budget = o.budget != kUsualBudget ? o.budget : any ? kNoBudget : kBudget;
    pack::Report report =
        pack::makeReport(pack::attribute(file, given.map, given.symbols, program), encoded.bits,
                         packed.size(), overhead, given.rooms ? &*given.rooms : nullptr);
    writeReports(o, report, program, budget, given.before);
    if (o.saveModel)
        write(o.saveModel, "# contexts that suit " + lastName(o.in) + ", found by pack --effort\n" +
                               pack::printParameters(parameters));
    if (budget >= 0 && size > budget)
        throw Refusal{"over budget by " + std::to_string(size - budget) + " bytes", 1};
    write(o.out, packed.data(), packed.size(), true);
    if (o.text && !std::strcmp(o.text, "-")) return;
    std::printf("%s: %ld bytes (%zu of them stub and headers) from %zu", o.out, size, overhead,
                program.bytes.size());
    if (before >= 0) std::printf(", before %ld (%+ld)", before, size - before);
    if (budget >= 0) std::printf(", %ld bytes left of %ld", budget - size, budget);
    std::puts("");
    if (any) warn(o, program, pack::appendedBytes(file), seconds);
}

void run(const Options &o) {
    const char *name = o.in ? o.in : o.test ? o.test : o.unpack;
    try {
        if (o.in) return makePacked(o);
        std::vector<uint8_t> file = read(name);
        const Way &way = pack::isPe(file) ? kPe : pack::isPackedLoader(file) ? kLoader : kMadeForIt;
        pack::Program program = way.read(file);
        if (o.test) {
            std::printf("%s: whole; %zu bytes of a program of %u in memory\n", name, program.bytes.size(),
                        program.span);
            return;
        }
        std::vector<uint8_t> plain = way.plain(program);
        write(o.out, plain.data(), plain.size(), true);
    } catch (const pack::Unsuitable &e) {
        throw Refusal{std::string(name) + ": " + e.what(), 2};
    }
}

} // namespace

int main(int argc, char **argv) {
    try {
        run(pack::parseOptions(argc, argv));
        if (std::fflush(stdout))
            throw Refusal{std::string("cannot write standard output: ") + std::strerror(errno), 2};
    } catch (const Refusal &r) {
        std::string line = r.line; // one line, whatever it repeats of what users gave
        std::replace_if(
            line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, '?');
        std::fprintf(stderr, "pack: %s\n", line.c_str());
        return r.status;
    }
}

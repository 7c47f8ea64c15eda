// pack_film: packs the film while it is built. It uses the code of pack but needs no library, so the film can
// be built where the libraries of pack are not installed.
#include "packer/model/model_parameters.h"
#include "packer/report/report.h"
#include "packer/write/packed_file.h"

#include <cstdio>
#include <cstdlib>

namespace pack {

namespace {

constexpr char kUsage[] =
    "usage: pack_film elf|pe IN OUT MODEL SAFE-NAME BUDGET MAP SYMBOLS REPORT\n"
    "       pack_film pe-plain IN OUT\n"
    "Packs the film in its build, for Linux or Windows; or writes it for Windows, not packed. The\n"
    "arguments are pack's options of the same names (pack --help); OUT is -o. SAFE-NAME may be empty.\n";

void packFilm(char **words) {
    std::string how = words[0], in = words[1], out = words[2], model = words[3], safeName = words[4],
                map = words[6], symbols = words[7], reportPath = words[8];
    long budget = std::atol(words[5]);
    bool pe = how == "pe";
    for (const std::string &output : {out, reportPath}) common::claimOutput(output);
    checkSafeName(safeName);
    Bytes file = readBytes(in);
    Program program = readProgram(file, pe ? kWindows : kLinux);
    PackedFile packed = makePacked(pe ? kPe : kElf, program, readParameters(model), safeName);
    auto stretches = attribute(file, common::readWhole(map), common::readWhole(symbols), program);
    Report report = makeReport(stretches, packed.bits, packed.used, packed.overhead);
    common::writeWhole(reportPath, printJson(report));
    checkBudget(out, packed, budget);
    writeBytes(out, packed.bytes, modeOf(in));
    std::printf("%s: %s (%zu of them stub and headers) from %zu in memory, %ld bytes left of %ld\n",
                out.c_str(), sizeText(packed).c_str(), packed.overhead, program.bytes.size(),
                budget - (long)packed.used, budget);
}

} // namespace

} // namespace pack

int main(int argc, char **argv) {
    try {
        std::string how = argc > 1 ? argv[1] : "";
        if (how == "--help" || how == "-h") {
            std::fputs(pack::kUsage, stdout);
            return 0;
        }
        if (how == "pe-plain" && argc == 4) {
            pack::Program program = pack::readProgram(pack::readBytes(argv[2]), pack::kWindows);
            pack::writeBytes(argv[3], pack::kPe.writePlain(program), pack::modeOf(argv[2]));
        } else if ((how == "elf" || how == "pe") && argc == 10)
            pack::packFilm(argv + 1);
        else
            throw common::Refused(
                "expected elf or pe and 8 arguments, or pe-plain IN OUT: see pack_film --help");
    } catch (const std::exception &e) {
        std::fprintf(stderr, "pack_film: %s\n", e.what());
        return dynamic_cast<const common::Refused *>(&e) ? 2 : 1;
    }
}

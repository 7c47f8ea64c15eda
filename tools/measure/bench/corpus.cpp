#include "tools/measure/bench/corpus.h"

#include "packer/read/programs.h"

#include <cstring>
#include <elf.h>
#include <filesystem>

namespace pack {

namespace {

// The section .text of an ELF file; empty if it has none.
Bytes instructions(const std::string &path) {
    if (!std::filesystem::exists(path)) return {};
    Bytes file = readBytes(path);
    if (file.size() < sizeof(Elf64_Ehdr)) return {};
    Elf64_Ehdr header;
    std::memcpy(&header, file.data(), sizeof header);
    auto section = [&](int i) {
        Elf64_Shdr s = {};
        uint64_t at = header.e_shoff + (uint64_t)i * sizeof s;
        if (at + sizeof s <= file.size()) std::memcpy(&s, file.data() + at, sizeof s);
        return s;
    };
    uint64_t names = section(header.e_shstrndx).sh_offset;
    for (int i = 0; i < header.e_shnum; ++i) {
        Elf64_Shdr s = section(i);
        if (names + s.sh_name + 6 <= file.size() && !std::memcmp(&file[names + s.sh_name], ".text", 6) &&
            s.sh_offset + s.sh_size <= file.size())
            return {file.begin() + (long)s.sh_offset, file.begin() + (long)(s.sh_offset + s.sh_size)};
    }
    return {};
}

} // namespace

Program programIn(const std::string &path) {
    Bytes file = readBytes(path);
    return common::inFile(path, [&] { return readProgram(file); });
}

std::vector<Sample> corpus(const std::string &film, std::vector<std::string> &missing) {
    const std::string lib = "/usr/lib/x86_64-linux-gnu/";
    const struct {
        const char *name;
        std::string path;
        size_t skip, size; // KB
    } all[] = {{"odraz", film, 16, 16},
               {"odraz", film, 32, 48},
               {"libm", lib + "libm.so.6", 128, 16},
               {"libm", lib + "libm.so.6", 32, 48},
               {"libstdc++", lib + "libstdc++.so.6", 64, 48},
               {"libstdc++", lib + "libstdc++.so.6", 128, 128},
               {"llvmpipe", lib + "dri/swrast_dri.so", 3072, 48},
               {"llvmpipe", lib + "dri/swrast_dri.so", 2048, 128},
               {"llvmpipe", lib + "dri/swrast_dri.so", 1024, 256}};
    std::vector<Sample> samples;
    for (auto &part : all) {
        Bytes code = instructions(part.path);
        std::string name = std::string(part.name) + " " + std::to_string(part.size) + "K";
        size_t from = part.skip * 1024, size = part.size * 1024;
        if (from + size > code.size())
            missing.push_back(name);
        else
            samples.push_back({name,
                               {code.begin() + (long)from, code.begin() + (long)(from + size)},
                               {(uint32_t)size, 0, (uint32_t)size}});
    }
    if (!std::filesystem::exists(film))
        missing.push_back(kWholeFilm);
    else {
        Program program = programIn(film);
        samples.push_back({kWholeFilm, program.bytes, program.layout()});
    }
    return samples;
}

} // namespace pack

#include "packer/report/disassembly.h"

#include "packer/read/process.h"

#include <cstdlib>
#include <sstream>

namespace pack {

namespace {

// "mov    eax,DWORD PTR [rip+0x10]        # 404010 <name>" without the symbol and the spaces that align.
std::string tidy(const std::string &line) {
    std::istringstream words(line.substr(0, line.find('<')));
    std::string text;
    for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    return text;
}

} // namespace

std::vector<Instruction> disassemble(const std::string &path) {
    std::vector<Instruction> all;
    std::istringstream lines(run({"objdump", "-d", "-w", "-z", "-M", "intel", "--", path}).output);
    // "  404a10:\t48 89 e5             \tmov    rbp,rsp"
    for (std::string line; std::getline(lines, line);) {
        size_t bytes = line.find(":\t"), text = line.find('\t', bytes + 2);
        if (line[0] != ' ' || bytes == line.npos) continue;
        Instruction i = {std::strtoull(line.c_str(), nullptr, 16), {}, ""};
        std::istringstream numbers(line.substr(bytes + 2, text - bytes - 2));
        for (unsigned byte; numbers >> std::hex >> byte;) i.bytes.push_back((uint8_t)byte);
        if (text != line.npos) i.text = tidy(line.substr(text));
        if (!i.bytes.empty() && i.bytes.size() <= 15) all.push_back(std::move(i));
    }
    return all;
}

} // namespace pack

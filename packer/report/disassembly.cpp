#include "packer/report/disassembly.h"

#include "tools/common/text.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace pack {

namespace {

// What a command prints. Throws std::runtime_error if no process can be started.
std::string outputOf(const std::string &command) {
    std::FILE *printed = popen(command.c_str(), "r");
    if (!printed) throw std::runtime_error("cannot run " + command + ": " + std::strerror(errno));
    std::string output;
    char buffer[1 << 16];
    while (size_t size = std::fread(buffer, 1, sizeof buffer, printed)) output.append(buffer, size);
    pclose(printed);
    return output;
}

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
    std::istringstream lines(
        outputOf("objdump -d -w -z -M intel -- " + common::shellWord(path) + " 2>/dev/null"));
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

#include "packer/report/disassembly.h"

#include "tools/common/text.h"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace pack {

namespace {

// objdump's standard output: nothing if it is not installed.
class Objdump {
public:
    explicit Objdump(const char *path) {
        std::string command = "objdump -d -w -z -M intel -- " + common::shellWord(path) + " 2>/dev/null";
        lines = popen(command.c_str(), "r");
    }
    ~Objdump() {
        if (lines) pclose(lines);
        std::free(line);
    }
    // The next line, or null. Good until the next call.
    const char *next() {
        ssize_t size = lines ? getline(&line, &space, lines) : -1;
        if (size > 0 && line[size - 1] == '\n') line[size - 1] = 0;
        return size > 0 ? line : nullptr;
    }

private:
    std::FILE *lines = nullptr;
    char *line = nullptr;
    size_t space = 0;
};

// "mov    eax,DWORD PTR [rip+0x10]        # 404010 <name>" without comment, symbol and spaces that align.
std::string tidy(const char *text) {
    std::string result;
    for (; *text && *text != '#' && *text != '<'; ++text)
        if (*text != ' ' || (!result.empty() && result.back() != ' ')) result += *text;
    while (!result.empty() && result.back() == ' ') result.pop_back();
    return result;
}

int64_t signedAt(const std::vector<uint8_t> &bytes, size_t at, size_t width) {
    uint64_t value = 0;
    std::memcpy(&value, bytes.data() + at, width);
    unsigned unused = 64 - 8 * (unsigned)width;
    return (int64_t)(value << unused) >> unused;
}

std::string field(char kind, size_t width, size_t at) {
    return std::string{'~', kind, (char)('0' + width), "0123456789abcdef"[at]};
}

// The field for a displacement, or "" if no bytes hold it. It stands in front of an immediate number.
std::string displacement(const Instruction &i, int64_t value) {
    for (size_t width : {1, 4})
        for (size_t at = 1; at + width <= i.bytes.size(); ++at)
            if (signedAt(i.bytes, at, width) == value) return field('s', width, at);
    return "";
}
// ... for an immediate number, which stands last.
std::string immediate(const Instruction &i, uint64_t value) {
    struct {
        char kind;
        uint64_t mask;
    } extended[] = {{'q', UINT64_MAX}, {'d', UINT32_MAX}, {'w', UINT16_MAX}, {'b', UINT8_MAX}};
    for (size_t width : {4, 1, 2, 8})
        for (auto &e : extended)
            if (i.bytes.size() > width &&
                ((uint64_t)signedAt(i.bytes, i.bytes.size() - width, width) & e.mask) == value)
                return field(e.kind, width, i.bytes.size() - width);
    return "";
}
std::string target(const Instruction &i, uint64_t value) {
    for (size_t width : {1, 4})
        if (i.bytes.size() > width &&
            i.address + i.bytes.size() + (uint64_t)signedAt(i.bytes, i.bytes.size() - width, width) == value)
            return field('j', width, i.bytes.size() - width);
    return "";
}

} // namespace

void disassemble(const char *path, const std::function<void(const Instruction &)> &visit) {
    Objdump objdump(path);
    // "  404a10:\t48 89 e5             \tmov    rbp,rsp"
    while (const char *line = objdump.next()) {
        char *at;
        uint64_t address = std::strtoull(line, &at, 16);
        if (line[0] != ' ' || at[0] != ':' || at[1] != '\t') continue;
        Instruction i = {address, {}, ""};
        for (at += 2; *at && *at != '\t';) {
            char *end;
            i.bytes.push_back((uint8_t)std::strtoul(at, &end, 16));
            if (end == at) break;
            for (at = end; *at == ' ';) ++at;
        }
        if (*at == '\t') i.text = tidy(at + 1);
        if (!i.bytes.empty() && i.bytes.size() <= 15) visit(i);
    }
}

std::string formOf(const Instruction &i) {
    std::string form(1, "0123456789abcdef"[i.bytes.size()]);
    const char *text = i.text.c_str();
    // A jump's target stands alone behind its name, without 0x
    const char *space = std::strrchr(text, ' ');
    char *end;
    if (space && space[1] != '0' && std::isxdigit((unsigned char)space[1])) {
        uint64_t value = std::strtoull(space + 1, &end, 16);
        std::string number = *end ? "" : target(i, value);
        if (!number.empty()) return form + std::string(text, space + 1) + number;
    }
    while (*text) {
        bool sign = (*text == '+' || *text == '-') && text[1] == '0' && text[2] == 'x';
        if (sign || (text[0] == '0' && text[1] == 'x')) {
            uint64_t value = std::strtoull(text + sign, &end, 16);
            std::string number =
                sign ? displacement(i, *text == '-' ? -(int64_t)value : (int64_t)value) : immediate(i, value);
            form += number.empty() ? std::string(text, (const char *)end) : number;
            text = end;
        } else
            form += *text++;
    }
    return form;
}

} // namespace pack

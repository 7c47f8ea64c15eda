#include "model_parameters.h"

#include <iterator>
#include <sstream>
#include <vector>

namespace pack {

namespace {

// Of the fields that contexts choose from: all from kByte1 on.
constexpr struct {
    uint32_t field;
    const char *name;
} kChoices[] = {
    {kByte1, "byte1"},     {kByte1 + 1, "byte2"}, {kByte1 + 2, "byte3"}, {kByte1 + 3, "byte4"},
    {kByte5, "byte5"},     {kColumn, "column"},   {kTarget, "target"},   {kInstruction1, "instruction1"},
    {kOpcode1, "opcode1"}, {kOpcode2, "opcode2"}, {kOpcode3, "opcode3"}, {kModrm1, "modrm1"},
    {kOpcode, "opcode"},   {kModrm, "modrm"},     {kMode, "mode"},       {kSoFar, "so-far"},
};
constexpr int kChoiceCount = kFields - kByte1;
consteval bool inOrderOfFields() {
    for (int i = 0; i < kChoiceCount; ++i)
        if (kChoices[i].field != (uint32_t)(kByte1 + i)) return false;
    return std::size(kChoices) == kChoiceCount;
}
static_assert(inOrderOfFields(), "a name for every field, in the order of their bits in a mask");
constexpr const char *kKinds[2][2] = {{"code", "code-weights"}, {"data", "data-weights"}};

std::string printMask(uint16_t mask) {
    std::string text;
    for (int i = 0; i < kChoiceCount; ++i)
        if (mask >> i & 1) text += (text.empty() ? "" : "+") + std::string(kChoices[i].name);
    return text.empty() ? "-" : text;
}

bool parseMask(const std::string &text, uint16_t &mask) {
    mask = 0;
    if (text == "-") return true;
    std::istringstream names(text);
    for (std::string name; std::getline(names, name, '+');) {
        int i = 0;
        while (i < kChoiceCount && name != kChoices[i].name) ++i;
        if (i == kChoiceCount) return false;
        mask = (uint16_t)(mask | 1 << i);
    }
    return mask != 0;
}

} // namespace

const ModelParameters &defaultParameters() {
    static const ModelParameters parameters = {
        16,
        22,
        {{0x0000, 0x0001, 0x1710, 0x0006, 0x1000, 0x8000, 0x0009, 0xa685, 0x1100, 0x1021, 0xdb20, 0xd900,
          0xa180, 0x8300, 0x4000, 0x4002, 0x0000, 0x0001, 0x1000, 0x0004, 0x0100, 0x0002, 0xba20},
         {0x8000, 0x1801, 0x0003, 0x2007, 0x000f, 0x0821, 0x2021, 0x0126, 0x0411, 0x2390, 0x1020, 0x0802,
          0x0208, 0x01bc, 0x4006, 0x581f, 0x8821, 0x0001, 0x0002, 0x0084, 0x0008, 0x0020, 0x0822}}};
    return parameters;
}

std::string printParameters(const ModelParameters &parameters) {
    std::string text = "slots " + std::to_string(parameters.slotBits) + "\n";
    for (int type = 0; type < 2; ++type)
        for (uint32_t i = 0; i < parameters.hashes(); ++i)
            text += std::string(kKinds[type][i >= parameters.contexts]) + " " +
                    printMask(parameters.masks[type][i]) + "\n";
    return text;
}

std::string parseParameters(const std::string &text, ModelParameters &parameters) {
    std::vector<uint16_t> masks[2][2];
    std::istringstream lines(text);
    int number = 0;
    parameters = {};
    for (std::string line; std::getline(lines, line);) {
        ++number;
        auto wrong = [&](const std::string &what) { return "line " + std::to_string(number) + ": " + what; };
        std::istringstream words(line);
        std::string kind, value, more;
        if (!(words >> kind) || kind[0] == '#') continue;
        if (!(words >> value) || words >> more) return wrong("a word and its value are needed");
        if (kind == "slots") {
            if (value.size() > 2 || value.find_first_not_of("0123456789") != std::string::npos)
                return wrong("slots needs a number of bits");
            if (parameters.slotBits) return wrong("slots is given twice");
            parameters.slotBits = (uint32_t)std::stoi(value);
            continue;
        }
        bool known = false;
        for (int type = 0; type < 2; ++type)
            for (int weights = 0; weights < 2; ++weights)
                if (kind == kKinds[type][weights]) {
                    uint16_t mask;
                    if (!parseMask(value, mask)) return wrong("unknown field in '" + value + "'");
                    masks[type][weights].push_back(mask);
                    known = true;
                }
        if (!known) return wrong("unknown word '" + kind + "'");
    }
    parameters.contexts = (uint32_t)masks[0][0].size();
    if (masks[1][0].size() != parameters.contexts || !parameters.sane())
        return "it needs slots " + std::to_string(kLeastSlotBits) + " to " + std::to_string(kMostSlotBits) +
               ", and as many contexts for data as for code: 4, 8, 12 .. " + std::to_string(kMostContexts);
    for (int type = 0; type < 2; ++type) {
        if (masks[type][1].size() != kSets - 1)
            return "it needs " + std::to_string(kSets - 1) + " lines " + kKinds[type][1];
        uint16_t *to = parameters.masks[type];
        for (auto &group : masks[type])
            for (uint16_t mask : group) *to++ = mask;
    }
    return "";
}

} // namespace pack

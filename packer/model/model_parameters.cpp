#include "packer/model/model_parameters.h"

#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace pack {

namespace {

// The names of the fields in model files.
constexpr std::pair<uint32_t, const char *> kNames[] = {
    {kColumn, "column"},     {kByte5, "byte5"},       {kByte4, "byte4"},
    {kByte3, "byte3"},       {kByte2, "byte2"},       {kByte1, "byte1"},
    {kToMark, "to-mark"},    {kTarget, "target"},     {kFunction, "function"},
    {kWritten1, "written1"}, {kWritten2, "written2"}, {kInstruction1, "instruction1"},
    {kOpcode1, "opcode1"},   {kOpcode2, "opcode2"},   {kOpcode3, "opcode3"},
    {kOpcode, "opcode"},     {kMode, "mode"},         {kSoFar, "so-far"},
};
static_assert(std::size(kNames) == kChoices);
// The words for contexts and selectors, in code and in data.
constexpr const char *kKinds[] = {"code", "code-weights", "data", "data-weights"};

std::string printMask(uint32_t mask) {
    std::string text;
    for (auto [field, name] : kNames)
        if (mask >> (field - kColumn) & 1) text += (text.empty() ? "" : "+") + std::string(name);
    return text.empty() ? "-" : text;
}

bool parseMask(const std::string &text, uint32_t &mask) {
    mask = 0;
    if (text == "-") return true;
    std::istringstream names(text);
    for (std::string name; std::getline(names, name, '+');) {
        auto found =
            std::find_if(std::begin(kNames), std::end(kNames), [&](auto &n) { return name == n.second; });
        if (found == std::end(kNames)) return false;
        mask |= 1u << (found->first - kColumn);
    }
    return mask != 0;
}

} // namespace

// Found by a search for the film. bench_pack measures how well they suit other programs.
const ModelParameters &defaultParameters() {
    static const ModelParameters parameters = {
        16,
        22,
        {{0x10000, 0x00020, 0x3b620, 0x00018, 0x00200, 0x38000, 0x08040, 0x0f000,
          0x09000, 0x18180, 0x00124, 0x21200, 0x00a20, 0x0b040, 0x10100, 0x00130,
          0x10040, 0x249b4, 0x00020, 0x08000, 0x00000, 0x01000, 0x00010},
         {0x8d, 0x20, 0x30, 0x78, 0x3c, 0x21, 0x00, 0xa1, 0xa7, 0x82, 0x81, 0x11,
          0x45, 0xc0, 0x19, 0x3e, 0x01, 0xb0, 0x40, 0x44, 0x10, 0x20, 0x03}}};
    return parameters;
}

// Found by a search for bash.
const ModelParameters &fastParameters() {
    static const ModelParameters parameters = {
        4,
        21,
        {{0x3be10, 0x00020, 0x38040, 0x29200, 0x20000, 0x19000, 0x00000, 0x18000, 0x00010, 0x249bc, 0x08040},
         {0x80, 0xb0, 0x78, 0x17, 0x41, 0x20, 0x45, 0x44, 0xd1, 0xb0, 0x0b}}};
    return parameters;
}

std::string printParameters(const ModelParameters &parameters) {
    std::string text = "slots " + std::to_string(parameters.slotBits) + "\n";
    for (int type = 0; type < 2; ++type)
        for (uint32_t i = 0; i < parameters.hashes(); ++i)
            text += std::string(kKinds[2 * type + (i >= parameters.contexts)]) + " " +
                    printMask(parameters.masks[type][i]) + "\n";
    return text;
}

ModelParameters parseParameters(const std::string &text) {
    std::vector<uint32_t> masks[std::size(kKinds)];
    std::istringstream lines(text);
    int number = 0;
    ModelParameters parameters = {};
    for (std::string line; std::getline(lines, line);) {
        ++number;
        auto wrong = [&](const std::string &what) {
            return common::Refused("line " + std::to_string(number) + ": " + what);
        };
        std::istringstream words(line);
        std::string kind, value, more;
        if (!(words >> kind) || kind[0] == '#') continue;
        if (!(words >> value) || words >> more) throw wrong("a word and its value are needed");
        if (kind == "slots") {
            if (value.size() > 2 || value.find_first_not_of("0123456789") != std::string::npos)
                throw wrong("slots needs a number of bits");
            if (parameters.slotBits) throw wrong("slots is given twice");
            parameters.slotBits = (uint32_t)std::stoi(value);
            continue;
        }
        auto i = (size_t)(std::find(std::begin(kKinds), std::end(kKinds), kind) - kKinds), type = i / 2;
        if (i == std::size(kKinds)) throw wrong("unknown word '" + kind + "'");
        uint32_t mask;
        if (!parseMask(value, mask)) throw wrong("unknown field in '" + value + "'");
        if (uint32_t others = mask & ~kMayUse[type])
            throw wrong("'" + printMask(others) + "' cannot be used in " + kKinds[2 * type]);
        masks[i].push_back(mask);
    }
    parameters.contexts = (uint32_t)masks[0].size();
    if (masks[2].size() != parameters.contexts || !parameters.sane())
        throw common::Refused(
            "it needs slots " + std::to_string(kLeastSlotBits) + " to " + std::to_string(kMostSlotBits) +
            ", and as many contexts for data as for code: " + "4, 8, 12 .. " + std::to_string(kMostContexts));
    for (int type = 0; type < 2; ++type) {
        const auto &contexts = masks[2 * type], &weights = masks[2 * type + 1];
        common::need(weights.size() == kSets - 1,
                     "it needs " + std::to_string(kSets - 1) + " lines " + kKinds[2 * type + 1]);
        std::copy(contexts.begin(), contexts.end(), parameters.masks[type]);
        std::copy(weights.begin(), weights.end(), parameters.masks[type] + contexts.size());
    }
    return parameters;
}

ModelParameters readParameters(const std::string &path) { return common::parseFile(path, parseParameters); }

} // namespace pack

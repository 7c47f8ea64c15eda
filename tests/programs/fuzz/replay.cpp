// replay SEED...: gives each seed to a reader, then damaged copies of it: cut short, or with bytes changed,
// removed, repeated or taken from another seed. Every run makes the same copies. The sanitizers report the
// reader's faults; the file `input` then has the input at fault.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

namespace {

constexpr int kDamagedCopies = 150; // for each seed

void run(const std::string &input) {
    std::ofstream("input", std::ios::binary) << input;
    LLVMFuzzerTestOneInput((const uint8_t *)input.data(), input.size());
}

// Changes the text in one to four places. Values at the edges of ranges find more faults.
std::string damaged(std::string text, const std::string &other, std::mt19937 &chance) {
    auto below = [&](size_t n) { return n ? chance() % n : 0; };
    static const uint8_t kEdges[] = {0x00, 0x01, 0x7f, 0x80, 0xff, '0', '-', '/', ' ', '\n'};
    for (size_t changes = 1 + below(4); changes && !text.empty(); --changes) {
        size_t at = below(text.size()), length = std::min(1 + below(16), text.size() - at);
        switch (below(6)) {
        case 0:
            text.resize(at);
            break;
        case 1:
            text[at] = (char)chance();
            break;
        case 2:
            std::fill_n(text.begin() + (long)at, length, (char)kEdges[below(sizeof kEdges)]);
            break;
        case 3:
            text.erase(at, length);
            break;
        case 4:
            text.insert(at, text.substr(at, length));
            break;
        default:
            text.replace(at, length, other.substr(std::min(below(other.size()), other.size()), length));
        }
    }
    return text;
}

} // namespace

int main(int argc, char **argv) {
    std::vector<std::string> seeds;
    for (int k = 1; k < argc; ++k) {
        std::ifstream from(argv[k], std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(from), std::istreambuf_iterator<char>());
        if (seeds.back().empty()) return std::fprintf(stderr, "replay: cannot read %s\n", argv[k]), 1;
    }
    std::mt19937 chance(1);
    long inputs = 0;
    for (const std::string &seed : seeds) {
        run(seed), ++inputs;
        for (int k = 0; k < kDamagedCopies; ++k, ++inputs)
            run(damaged(seed, seeds[chance() % seeds.size()], chance));
    }
    std::printf("%ld inputs\n", inputs);
    return inputs ? 0 : 1;
}

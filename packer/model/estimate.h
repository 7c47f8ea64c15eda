// Estimates a payload's size with other contexts, for the search, which needs thousands of estimates.
//
// A context's inputs depend on its own masks and on the bits coded; other contexts change them only where
// slots collide. So the inputs are kept, 16 bits each. For parameters that differ in one context, only that
// context's inputs are computed again, with a separate table of slots; then all are mixed, eight floats at a
// time (by AVX2 where the processor has it). The estimate is within 1 % of measure(), and the difference of
// two estimates is much more accurate.
#pragma once

#include "packer/model/decoder.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

namespace pack {

// A context's inputs, four for every bit; a selector's hashes, one for every byte.
using Inputs = std::shared_ptr<const std::vector<int16_t>>;
using Hashes = std::shared_ptr<const std::vector<uint32_t>>;

constexpr double kTooMany = 1e30;
constexpr float kInputUnit =
    1 << 13; // a step of the inputs, in a float's last bits; logarithms end at 24 << 23

// What is known about a byte, independent of the parameters.
struct Known {
    uint32_t fields[kMostFields];
    uint8_t byte, type;
    float odds[8]; // a bit each
};

// ... about all bytes.
template <class Around = Surroundings>
std::vector<Known> knownOf(const std::vector<uint8_t> &filtered, const Layout &layout) {
    std::vector<Known> all(filtered.size());
    std::vector<typename Around::Place> places(kPast + filtered.size() + kFuture);
    Around s = {};
    s.places = places.data() + kPast;
    s.size = layout.size;
    uint8_t opcodes[kOpcodes];
    s.prepare(opcodes);
    for (uint32_t i = 0; i < filtered.size(); ++i) {
        s.begin(i);
        Known &known = all[i];
        std::copy(std::begin(s.fields), std::end(s.fields), known.fields);
        known.type = i - layout.codeBegin >= layout.codeSize;
        known.byte = filtered[i];
        for (uint32_t k = 0; k < 8; ++k)
            known.odds[k] = logOf(s.odds((0x100u | filtered[i]) >> (8 - k))) * (1 / kInputUnit);
        s.places[i].byte = filtered[i];
        if (!known.type) s.end(i, filtered[i], opcodes);
    }
    return all;
}

struct Estimate {
    ModelParameters parameters;
    double bytes = 0;         // of the payload; kTooMany if the estimate was abandoned
    std::vector<float> curve; // bytes of payload after each kStretch bytes of the program
    std::vector<Inputs> inputs;
    std::vector<Hashes> selectors;
};

extern template std::vector<Known> knownOf<Surroundings>(const std::vector<uint8_t> &, const Layout &);

// Use one for each thread. It holds some tens of megabytes of working memory.
class Estimator {
public:
    Estimator(std::vector<Known> all, const Layout &layout);
    ~Estimator();

    // Reuses what is the same in `like`. Abandons the estimate where it is more than `slack` bytes larger
    // than `like`.
    Estimate operator()(const ModelParameters &parameters, const Estimate *like = nullptr,
                        double slack = kTooMany);

private:
    struct Work;
    std::unique_ptr<Work> work;
};

} // namespace pack

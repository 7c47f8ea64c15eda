// Estimates a payload's size with other contexts, for the search, which needs thousands of estimates.
//
// A context's inputs depend on its own masks and on the bits coded; other contexts change them only where
// slots collide. So the inputs are kept, 16 bits each. For parameters that differ in one context, only that
// context's inputs are computed again, with a separate table of slots; then all are mixed, eight floats at a
// time (by AVX2 where the processor has it). The estimate is within 1 % of measure(), and the difference of
// two estimates is much more accurate.
#pragma once

#include "packer/model/decoder.h"

#include <memory>
#include <vector>

namespace pack {

// A context's inputs, four for every bit; a selector's hashes, one for every byte.
using Inputs = std::shared_ptr<const std::vector<int16_t>>;
using Hashes = std::shared_ptr<const std::vector<uint32_t>>;

constexpr double kTooMany = 1e30;

struct Estimate {
    ModelParameters parameters;
    double bytes = 0;         // of the payload; kTooMany if the estimate was abandoned
    std::vector<float> curve; // bytes of payload after each kStretch bytes of the program
    std::vector<Inputs> inputs;
    std::vector<Hashes> selectors;
};

// Use one for each thread. It holds some tens of megabytes of working memory.
class Estimator {
public:
    Estimator(const std::vector<uint8_t> &filtered, const Layout &layout);
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

// What a payload would come to with other contexts, estimated: for the search, which asks thousands of times.
//
// A context's inputs depend on its own masks and on the bits coded, and on other contexts only where slots
// collide. So they are kept, 16 bits each. For parameters that differ in one context, only that
// context's inputs are computed, from a table of its own; then all are mixed, with vectors of eight where the
// processor has AVX2. The estimate is within 1 % of measure(), and much nearer where two estimates are
// compared.
#pragma once

#include "decoder.h"

#include <memory>
#include <vector>

namespace pack {

// Inputs of a context for every bit, four with a zero; hashes of a selector for every byte.
using Inputs = std::shared_ptr<const std::vector<int16_t>>;
using Hashes = std::shared_ptr<const std::vector<uint32_t>>;

constexpr double kTooMany = 1e30;

struct Estimate {
    ModelParameters parameters;
    double bytes = 0;         // of payload; kTooMany if it was given up
    std::vector<float> curve; // what the payload comes to after each kStretch bytes of the program
    std::vector<Inputs> inputs;
    std::vector<Hashes> selectors;
};

// One for each thread: it keeps some tens of megabytes to work in.
class Estimator {
public:
    Estimator(const std::vector<uint8_t> &filtered, const Layout &layout);
    ~Estimator();

    // Takes from `like` what is the same there. Gives up, if `slack` is given, where it is that many bytes
    // behind `like`.
    Estimate operator()(const ModelParameters &parameters, const Estimate *like = nullptr,
                        double slack = kTooMany);

private:
    struct Work;
    std::unique_ptr<Work> work;
};

} // namespace pack

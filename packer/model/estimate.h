// Estimates the size of a payload with other contexts. The search needs thousands of such estimates.
//
// A context's inputs depend on its own masks and on the coded bits; other contexts change them only where
// slots collide. So an estimate keeps its inputs, 16 bits each. If the next parameters differ in one context,
// only that context's inputs are computed again, with a separate table of slots. Then all inputs are mixed,
// eight floats at a time (by AVX2 where the processor has it). The estimate is within 1 % of Encoded::size(),
// and the difference of two estimates is much more accurate.
#pragma once

#include "packer/model/encoder.h"

#include <iterator>

namespace pack {

// A context's inputs, four for each bit; and a selector's hashes, one for each byte.
using Inputs = std::shared_ptr<const std::vector<int16_t>>;
using Hashes = std::shared_ptr<const std::vector<uint32_t>>;

constexpr double kTooMany = 1e30; // bytes
// One unit of the 16-bit inputs, in units of kLogUnit. The largest logarithm, 24 << 23, still fits in 16 bits
constexpr float kInputUnit = 1 << 13;

// The part of the model's input that does not depend on the parameters, for one byte.
struct ByteRecord {
    uint32_t fields[kMostFields];
    uint8_t byte, type;
    float odds[8]; // one for each bit
};

// Returns the records of all bytes.
template <class Tracker = X86Tracker>
std::vector<ByteRecord> byteRecords(const Bytes &filtered, const Layout &layout) {
    std::vector<ByteRecord> all(filtered.size());
    std::vector<typename Tracker::CodedByte> coded(kPast + filtered.size() + kFuture);
    Tracker tracker = {};
    tracker.coded = coded.data() + kPast;
    tracker.size = layout.size;
    uint8_t opcodes[kOpcodes];
    tracker.prepare(opcodes);
    for (uint32_t i = 0; i < filtered.size(); ++i) {
        tracker.begin(i);
        ByteRecord &record = all[i];
        std::copy(std::begin(tracker.fields), std::end(tracker.fields), record.fields);
        record.type = i - layout.codeBegin >= layout.codeSize;
        record.byte = filtered[i];
        for (uint32_t k = 0; k < 8; ++k)
            record.odds[k] = logOf(tracker.odds((0x100u | filtered[i]) >> (8 - k))) * (1 / kInputUnit);
        tracker.coded[i].byte = filtered[i];
        if (!record.type) tracker.end(i, filtered[i], opcodes);
    }
    return all;
}

struct Estimate {
    ModelParameters parameters;
    double bytes = 0;         // size of the payload; kTooMany if the estimate was abandoned
    std::vector<float> curve; // size of the payload after each kCompareStep bytes of the program
    std::vector<Inputs> inputs;
    std::vector<Hashes> selectors;
};

// Each thread needs its own estimator, which holds some tens of megabytes of working memory.
class Estimator {
public:
    explicit Estimator(std::vector<ByteRecord> records);
    ~Estimator();

    // Reuses those inputs and hashes of `base` whose masks are the same. Abandons the estimate as soon as its
    // payload is more than `slack` bytes larger than the payload of `base` up to the same byte.
    Estimate operator()(const ModelParameters &parameters, const Estimate *base = nullptr,
                        double slack = kTooMany);

private:
    struct Impl;
    std::unique_ptr<Impl> impl;
};

} // namespace pack

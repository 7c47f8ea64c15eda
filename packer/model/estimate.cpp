#include "packer/model/estimate.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace pack {

namespace {

typedef float Float8 __attribute__((vector_size(32)));
typedef int32_t Int8 __attribute__((vector_size(32)));
typedef int16_t Short8 __attribute__((vector_size(16)));

constexpr uint32_t kLanes = 4; // inputs of each context
// Vectors of eight inputs. The last one has the odds, the constant and the count of uses
constexpr uint32_t kMost8 = kMostContexts * kLanes / 8 + 1;
constexpr uint32_t kCompareStep = 2048; // bytes between two comparisons with another estimate
constexpr float kRate = kLearning * kInputUnit, kEarlyRate = kEarlyLearning * kInputUnit,
                kFinalRate = kFinalLearning * kInputUnit, kMostResult = kMostSum / kInputUnit;

// The mixer's state, and the size of the payload so far in bits.
struct alignas(64) Mixer {
    Counter corrections[1 << kCorrectionRowBits][1 << kCorrectionBits];
    Float8 finalWeights[kPhases], weights[kSets][kRows][kMost8];
    double bits;
};

// The inputs of each context and the hashes of each selector, for all bytes.
struct Sources {
    const int16_t *inputs[kMostContexts];
    const uint32_t *selectors[kSets - 1];
    uint32_t contexts;
    const ByteRecord *records;
};

// The rows that a bit selects. All bits are known, so the rows of the next bit are prefetched: without
// that, most time would be spent waiting for memory.
struct SelectedRows {
    Float8 *weights[kSets];
    Counter *corrections;

    [[gnu::always_inline]] SelectedRows(Mixer &m, const Sources &from, uint32_t at, uint32_t bits,
                                        uint32_t count) {
        uint32_t phase = phaseOf(from.records[at].fields);
        for (uint32_t s = 0; s < kSets; ++s) {
            weights[s] = m.weights[s][rowOf(s, s ? from.selectors[s - 1][at] : 0, phase, bits)];
            for (uint32_t i = 0; i < count; i += 2) __builtin_prefetch(weights[s] + i, 1);
        }
        corrections = m.corrections[mixIn(from.selectors[0][at], bits) >> (32 - kCorrectionRowBits)];
        __builtin_prefetch(corrections, 1);
        __builtin_prefetch(corrections + 16, 1);
    }
};

[[gnu::always_inline]] inline float sumOf(const Float8 &v) {
    return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

// Converts the inputs of a bit to floats.
[[gnu::always_inline]] inline void loadInputs(Float8 *x, const Sources &from, size_t offset, float odds,
                                              uint32_t count) {
#pragma GCC unroll 8
    for (uint32_t i = 0; i + 1 < count; ++i) {
        union {
            int64_t pair[2];
            Short8 all;
        } in;
        std::memcpy(&in.pair[0], from.inputs[2 * i] + offset, 8);
        std::memcpy(&in.pair[1], from.inputs[2 * i + 1] + offset, 8);
        x[i] = __builtin_convertvector(__builtin_convertvector(in.all, Int8), Float8);
    }
    x[count - 1] = Float8{odds, kConstant / kInputUnit};
}

// Computes the result of each set: the sum of its weighted inputs.
[[gnu::always_inline]] inline void mixSets(Float8 &results, const SelectedRows &rows, const Float8 *x,
                                           uint32_t count) {
#pragma GCC unroll 8
    for (uint32_t s = 0; s < kSets; ++s) {
        const Float8 *w = rows.weights[s];
        Float8 sum = w[0] * x[0], sum2 = w[1] * x[1];
#pragma GCC unroll 8
        for (uint32_t i = 2; i + 1 < count; i += 2) {
            sum += w[i] * x[i];
            sum2 += w[i + 1] * x[i + 1];
        }
        results[s] = sumOf(sum + sum2 + w[count - 1] * x[count - 1]);
    }
    results = results > kMostResult ? kMostResult : results;
    results = results < -kMostResult ? -kMostResult : results;
}

// Returns the corrected probability of a one, and trains the correction.
[[gnu::always_inline]] inline float correct(const SelectedRows &rows, float sum, float mixed, uint32_t bit) {
    Counter &correction = rows.corrections[(int32_t)(sum * (kSteepness * kInputUnit) + kMiddle)];
    int32_t p = (int32_t)(mixed * (1 << kProbabilityBits));
    if (!correction) correction = (uint32_t)(p - kHalf) << kSeenBits | kFirstTrust;
    float one =
        (float)((((int32_t)correction >> kSeenBits) + kHalf + 3 * p) | 1) * (0.25f / (1 << kProbabilityBits));
    adapt(correction, bit, kSettled[0]);
    return one;
}

// Trains the selected rows of all sets for the bit y.
[[gnu::always_inline]] inline void trainSets(const SelectedRows &rows, const Float8 *x, const Float8 &results,
                                             float y, uint32_t count) {
    Int8 odds = __builtin_convertvector(results * kInputUnit, Int8) + std::bit_cast<int32_t>(1.0f);
    Float8 squashed = (Float8)odds / ((Float8)odds + 1), used, steps;
    for (uint32_t s = 0; s < kSets; ++s) used[s] = rows.weights[s][count - 1][kLanes - 1]++;
    steps = (y - squashed) * (kEarlyRate / (used + kEarlyUses) + kRate);
#pragma GCC unroll 8
    for (uint32_t s = 0; s < kSets; ++s)
#pragma GCC unroll 9
        for (uint32_t i = 0; i < count; ++i) rows.weights[s][i] += x[i] * steps[s];
}

// Predicts and learns the bytes from `at` to `end`. `count`: vectors of inputs.
[[gnu::always_inline]] inline void mixBytes(Mixer &m, const Sources &from, uint32_t at, uint32_t end,
                                            uint32_t count) {
    SelectedRows next(m, from, at, 1, count);
    for (; at < end; ++at) {
        uint32_t bits = 1;
        double likelihood = 1;
        Float8 &last = m.finalWeights[phaseOf(from.records[at].fields)];
        for (int shift = 7; shift >= 0; --shift) {
            uint32_t bit = from.records[at].byte >> shift & 1;
            SelectedRows rows = next;
            if (shift)
                next = SelectedRows(m, from, at, bits * 2 + bit, count);
            else if (at + 1 < end)
                next = SelectedRows(m, from, at + 1, 1, count);
            Float8 x[kMost8] = {}, results;
            size_t offset = (size_t)at * (8 * kLanes) + (7 - (size_t)shift) * kLanes;
            loadInputs(x, from, offset, from.records[at].odds[7 - shift], count);
            mixSets(results, rows, x, count);
            float sum = std::clamp(sumOf(last * results), -kMostResult, kMostResult),
                  mixed = squash(sum * kInputUnit), one = correct(rows, sum, mixed, bit),
                  y = (float)(int32_t)bit;
            likelihood *= bit ? one : 1 - one;
            trainSets(rows, x, results, y, count);
            last += results * ((y - mixed) * kFinalRate);
            bits = bits * 2 + bit;
        }
        m.bits -= std::log2(likelihood);
    }
}

[[gnu::always_inline]] inline void mixAny(Mixer &m, const Sources &from, uint32_t at, uint32_t end) {
    if (from.contexts == 16)
        mixBytes(m, from, at, end, 9); // the default number of contexts, with all loops unrolled
    else
        mixBytes(m, from, at, end, from.contexts * kLanes / 8 + 1);
}
void mixPlain(Mixer &m, const Sources &from, uint32_t at, uint32_t end) { mixAny(m, from, at, end); }
__attribute__((target("avx2,fma"))) void mixAvx2(Mixer &m, const Sources &from, uint32_t at, uint32_t end) {
    mixAny(m, from, at, end);
}
const auto mix8 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? mixAvx2 : mixPlain;

} // namespace

struct Estimator::Impl {
    std::vector<ByteRecord> records;
    std::unique_ptr<Mixer> mixer{new Mixer()};
    std::unique_ptr<Context> context{new Context()};
    std::vector<Slot> slots = {};

    // Returns the hashes of selector i for all bytes.
    Hashes hashesOf(const ModelParameters &parameters, uint32_t i) const {
        std::vector<uint32_t> hashes;
        for (const ByteRecord &r : records) hashes.push_back(hashOf(parameters, r.type, i, r.fields));
        return std::make_shared<std::vector<uint32_t>>(std::move(hashes));
    }

    // Computes the inputs of context i for the bytes from `at` to `end`.
    void computeInputs(const ModelParameters &parameters, uint32_t i, uint32_t slotBits, uint32_t at,
                       uint32_t end, int16_t *to) {
        if (at == 0) {
            slots.assign(1u << slotBits, Slot{});
            std::memset((void *)context.get(), 0, sizeof *context);
        }
        // Returns the hash of the byte's context, and prefetches its slots
        auto hashAndPrefetch = [&](const ByteRecord &byte) {
            uint32_t hash = hashOf(parameters, byte.type, i, byte.fields), nibble = hash;
            for (uint32_t start : {1u, 16u + (byte.byte >> 4)}) {
                nibble = mixIn(nibble, start);
                const Slot *first = nibbleSlots(slots.data(), slotBits, nibble);
                for (uint32_t k = 0; k < kWays * kNibbleSlots; k += 64 / sizeof(Slot))
                    __builtin_prefetch(first + k, 1);
            }
            return hash;
        };
        Context &c = *context;
        to += (size_t)at * (8 * kLanes);
        uint32_t nextHash = hashAndPrefetch(records[at]);
        for (; at < end; ++at) {
            const ByteRecord &byte = records[at];
            uint32_t hash = nextHash, phase = phaseOf(byte.fields), bits = 1;
            if (at + 1 < end) nextHash = hashAndPrefetch(records[at + 1]);
            for (int shift = 7; shift >= 0; --shift, to += kLanes) {
                uint32_t bit = byte.byte >> shift & 1;
                Nibble nibble = nibbleOf(bits);
                if (nibble.step == 1) hash = mixIn(hash, nibble.start);
                findCounters(c, slots.data(), slotBits, hash, phase, nibble);
                Float4 inputs = inputsOf(c.counter) * (1 / kInputUnit);
                for (uint32_t k = 0; k < kLanes; ++k) to[k] = (int16_t)inputs[k];
                learn(c, bit);
                bits = bits * 2 + bit;
            }
            c.byteSlot->lastByte = byte.byte;
        }
    }
};

Estimator::Estimator(std::vector<ByteRecord> records) : impl(new Impl{std::move(records)}) {}
Estimator::~Estimator() = default;

Estimate Estimator::operator()(const ModelParameters &parameters, const Estimate *base, double slack) {
    Impl &w = *impl;
    uint32_t size = (uint32_t)w.records.size();
    Estimate e;
    e.parameters = parameters;
    auto same = [&](uint32_t i) {
        return base && parameters.contexts == base->parameters.contexts &&
               parameters.masks[0][i] == base->parameters.masks[0][i] &&
               parameters.masks[1][i] == base->parameters.masks[1][i];
    };

    // Compute the inputs and hashes that `base` lacks. Each context has a part of the slots for itself
    uint32_t slotBits = parameters.slotBits - (uint32_t)std::bit_width(parameters.contexts - 1);
    Sources from = {{}, {}, parameters.contexts, w.records.data()};
    // The inputs of the last context to compute. They are computed while mixing, only as far as needed
    std::vector<int16_t> *deferred = nullptr;
    uint32_t deferredContext = 0;
    for (uint32_t i = 0; i < parameters.contexts; ++i) {
        if (same(i))
            e.inputs.push_back(base->inputs[i]);
        else {
            if (deferred) w.computeInputs(parameters, deferredContext, slotBits, 0, size, deferred->data());
            auto inputs = std::make_shared<std::vector<int16_t>>((size_t)size * (8 * kLanes));
            deferred = inputs.get();
            deferredContext = i;
            e.inputs.push_back(inputs);
        }
        from.inputs[i] = e.inputs[i]->data();
    }
    for (uint32_t i = 0; i < kSets - 1; ++i) {
        uint32_t selector = parameters.contexts + i;
        e.selectors.push_back(same(selector) ? base->selectors[i] : w.hashesOf(parameters, selector));
        from.selectors[i] = e.selectors[i]->data();
    }

    // Mix until the end, or until the estimate is too large
    Mixer &m = *w.mixer;
    std::memset((void *)m.corrections, 0, sizeof m.corrections);
    float *weights = (float *)m.finalWeights;
    std::fill(weights, weights + (sizeof m.finalWeights + sizeof m.weights) / sizeof(float), kFirstWeight);
    m.bits = 0;
    for (uint32_t at = 0; at < size; at += kCompareStep) {
        uint32_t end = std::min(size, at + kCompareStep);
        if (deferred) w.computeInputs(parameters, deferredContext, slotBits, at, end, deferred->data());
        mix8(m, from, at, end);
        e.curve.push_back((float)(m.bits / 8));
        if (base && slack < kTooMany && e.curve.back() > base->curve[e.curve.size() - 1] + slack) {
            e.bytes = kTooMany;
            return e;
        }
    }
    e.bytes = m.bits / 8;
    return e;
}

} // namespace pack

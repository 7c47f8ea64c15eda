#include "packer/model/estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace pack {

namespace {

typedef float Float8 __attribute__((vector_size(32)));
typedef int32_t Int8 __attribute__((vector_size(32)));
typedef int16_t Short8 __attribute__((vector_size(16)));

constexpr uint32_t kLanes = 4;                              // floats of a context: its inputs
constexpr uint32_t kMost8 = kMostContexts * kLanes / 8 + 1; // the last has the odds, and counts uses
constexpr uint32_t kStretch = 2048; // bytes between two comparisons with another estimate
constexpr float kRate = kLearning * kInputUnit, kEarlyRate = kEarlyLearning * kInputUnit,
                kFinalRate = kFinalLearning * kInputUnit;

// The mixer's state, and the payload's bits so far.
struct alignas(64) Mixer {
    Counter corrections[1 << kCorrectionRowBits][1 << kCorrectionBits];
    Float8 finalWeights[kPhases], weights[kSets][kRows][kMost8];
    double bits;
};

// The contexts' inputs and the selectors' hashes of all bytes.
struct Sources {
    const int16_t *inputs[kMostContexts];
    const uint32_t *selectors[kSets - 1];
    uint32_t contexts;
};

// The rows that a bit selects. All bits are known beforehand, so the next bit's rows can be prefetched;
// without that, the time would go into waiting for memory.
struct Rows {
    Float8 *weights[kSets];
    Counter *corrections;

    [[gnu::always_inline]] Rows(Mixer &m, const Sources &from, const Known *all, uint32_t at, uint32_t bits,
                                uint32_t count) {
        uint32_t phase = phaseOf(all[at].fields);
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

// predict() and learn() for the bytes from `at` to `end`; `count` vectors of inputs.
[[gnu::always_inline]] inline void mixBytes(Mixer &m, const Sources &from, const Known *all, uint32_t at,
                                            uint32_t end, uint32_t count) {
    constexpr float kMost = kMostSum / kInputUnit;
    Rows next(m, from, all, at, 1, count);
    for (; at < end; ++at) {
        uint32_t bits = 1;
        double likely = 1;
        Float8 &last = m.finalWeights[phaseOf(all[at].fields)];
        for (int shift = 7; shift >= 0; --shift) {
            uint32_t bit = all[at].byte >> shift & 1;
            Rows rows = next;
            if (shift)
                next = Rows(m, from, all, at, bits * 2 + bit, count);
            else if (at + 1 < end)
                next = Rows(m, from, all, at + 1, 1, count);
            Float8 x[kMost8] = {}, results;
            size_t offset = (size_t)at * (8 * kLanes) + (7 - (size_t)shift) * kLanes;
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
            x[count - 1] = Float8{all[at].odds[7 - shift], kConstant / kInputUnit};
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
            results = results > kMost ? kMost : results;
            results = results < -kMost ? -kMost : results;
            float sum = std::clamp(sumOf(last * results), -kMost, kMost), mixed = squash(sum * kInputUnit);

            // Correct
            Counter &correction = rows.corrections[(int32_t)(sum * (kSteepness * kInputUnit) + kMiddle)];
            int32_t p = (int32_t)(mixed * (1 << kProbabilityBits));
            if (!correction) correction = (uint32_t)(p - kHalf) << kSeenBits | kFirstTrust;
            float one = (float)((((int32_t)correction >> kSeenBits) + kHalf + 3 * p) | 1) *
                        (0.25f / (1 << kProbabilityBits));
            likely *= bit ? one : 1 - one;
            adapt(correction, bit, kSettled[0]);

            // Learn
            float y = (float)(int32_t)bit;
            Int8 odds = __builtin_convertvector(results * kInputUnit, Int8) + std::bit_cast<int32_t>(1.0f);
            Float8 squashed = (Float8)odds / ((Float8)odds + 1), used, by;
            for (uint32_t s = 0; s < kSets; ++s) used[s] = rows.weights[s][count - 1][kLanes - 1]++;
            by = (y - squashed) * (kEarlyRate / (used + kEarlyUses) + kRate);
#pragma GCC unroll 8
            for (uint32_t s = 0; s < kSets; ++s)
#pragma GCC unroll 9
                for (uint32_t i = 0; i < count; ++i) rows.weights[s][i] += x[i] * by[s];
            last += results * ((y - mixed) * kFinalRate);
            bits = bits * 2 + bit;
        }
        m.bits -= std::log2(likely);
    }
}

[[gnu::always_inline]] inline void mixAny(Mixer &m, const Sources &from, const Known *all, uint32_t at,
                                          uint32_t end) {
    if (from.contexts == 16)
        mixBytes(m, from, all, at, end, 9); // the default number, with all loops unrolled
    else
        mixBytes(m, from, all, at, end, from.contexts * kLanes / 8 + 1);
}
void mixPlain(Mixer &m, const Sources &from, const Known *all, uint32_t at, uint32_t end) {
    mixAny(m, from, all, at, end);
}
__attribute__((target("avx2,fma"))) void mixAvx2(Mixer &m, const Sources &from, const Known *all, uint32_t at,
                                                 uint32_t end) {
    mixAny(m, from, all, at, end);
}
const auto mix8 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? mixAvx2 : mixPlain;

} // namespace

struct Estimator::Work {
    Layout layout;
    std::vector<Known> all;
    std::unique_ptr<Mixer> mixer{new Mixer()};
    std::unique_ptr<Context> context{new Context()};
    std::vector<Slot> slots;
    std::vector<int16_t> nothing;

    // A context's inputs for the bytes from `at` to `end`.
    void computeInputs(const ModelParameters &parameters, uint32_t i, uint32_t slotBits, uint32_t at,
                       uint32_t end, int16_t *to) {
        if (at == 0) {
            slots.assign(1u << slotBits, Slot{});
            std::memset((void *)context.get(), 0, sizeof *context);
        }
        // Prefetches the slots of the next byte
        auto next = [&](const Known &known) {
            uint32_t hash = hashOf(parameters, known.type, i, known.fields);
            uint32_t nibble = hash;
            for (uint32_t start : {1u, 16u + (known.byte >> 4)}) {
                nibble = mixIn(nibble, start);
                Slot *first = &slots[nibble >> (32 - slotBits) & ~(kWays * kNibbleSlots - 1)];
                for (uint32_t k = 0; k < kWays * kNibbleSlots; k += 64 / sizeof(Slot))
                    __builtin_prefetch(first + k, 1);
            }
            return hash;
        };
        Context &c = *context;
        to += (size_t)at * (8 * kLanes);
        uint32_t coming = next(all[at]);
        for (; at < end; ++at) {
            const Known &known = all[at];
            uint32_t hash = coming, phase = phaseOf(known.fields), bits = 1;
            if (at + 1 < end) coming = next(all[at + 1]);
            for (int shift = 7; shift >= 0; --shift, to += kLanes) {
                uint32_t bit = known.byte >> shift & 1;
                Nibble nibble = nibbleOf(bits);
                if (nibble.step == 1) hash = mixIn(hash, nibble.start);
                find(c, slots.data(), slotBits, hash, phase, nibble);
                Float4 inputs = inputsOf(c.counter) * (1 / kInputUnit);
                for (uint32_t k = 0; k < kLanes; ++k) to[k] = (int16_t)inputs[k];
                learn(c, bit);
                bits = bits * 2 + bit;
            }
            c.byteSlot->lastByte = known.byte;
        }
    }
};

template std::vector<Known> knownOf<Surroundings>(const std::vector<uint8_t> &, const Layout &);

Estimator::Estimator(std::vector<Known> all, const Layout &layout) : work(new Work) {
    work->layout = layout;
    work->all = std::move(all);
}

Estimator::~Estimator() = default;

Estimate Estimator::operator()(const ModelParameters &parameters, const Estimate *like, double slack) {
    Work &w = *work;
    uint32_t size = (uint32_t)w.all.size();
    Estimate e;
    e.parameters = parameters;
    auto same = [&](uint32_t i) {
        return like && parameters.contexts == like->parameters.contexts &&
               parameters.masks[0][i] == like->parameters.masks[0][i] &&
               parameters.masks[1][i] == like->parameters.masks[1][i];
    };

    // Each context has its share of the slots
    uint32_t slotBits = parameters.slotBits - (uint32_t)std::bit_width(parameters.contexts - 1);
    Sources from = {{}, {}, parameters.contexts};
    std::vector<int16_t> *late = nullptr; // inputs that are computed stretch by stretch, as far as needed
    uint32_t lateContext = 0;
    for (uint32_t i = 0; i < parameters.contexts; ++i) {
        if (same(i))
            e.inputs.push_back(like->inputs[i]);
        else {
            if (late) w.computeInputs(parameters, lateContext, slotBits, 0, size, late->data());
            auto inputs = std::make_shared<std::vector<int16_t>>((size_t)size * (8 * kLanes));
            late = inputs.get();
            lateContext = i;
            e.inputs.push_back(inputs);
        }
        from.inputs[i] = e.inputs[i]->data();
    }
    for (uint32_t i = 0; i < kSets - 1; ++i) {
        if (same(parameters.contexts + i))
            e.selectors.push_back(like->selectors[i]);
        else {
            auto hashes = std::make_shared<std::vector<uint32_t>>(size);
            for (uint32_t at = 0; at < size; ++at)
                (*hashes)[at] = hashOf(parameters, w.all[at].type, parameters.contexts + i, w.all[at].fields);
            e.selectors.push_back(hashes);
        }
        from.selectors[i] = e.selectors[i]->data();
    }

    Mixer &m = *w.mixer;
    std::memset((void *)m.corrections, 0, sizeof m.corrections);
    float *weights = (float *)m.finalWeights;
    std::fill(weights, weights + (sizeof m.finalWeights + sizeof m.weights) / sizeof(float), kFirstWeight);
    m.bits = 0;
    for (uint32_t at = 0; at < size; at += kStretch) {
        uint32_t end = std::min(size, at + kStretch);
        if (late) w.computeInputs(parameters, lateContext, slotBits, at, end, late->data());
        mix8(m, from, w.all.data(), at, end);
        e.curve.push_back((float)(m.bits / 8));
        if (like && slack < kTooMany && e.curve.back() > like->curve[e.curve.size() - 1] + slack) {
            e.bytes = kTooMany;
            return e;
        }
    }
    e.bytes = m.bits / 8;
    return e;
}

} // namespace pack

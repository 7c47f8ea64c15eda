// The model: it predicts the next bit from the bits that followed the same contexts before.
//
// Context mixing, as in Mahoney's PAQ. A context is a choice of fields (x86.h), whose values are hashed.
// Together with the bits of the byte so far, the hash selects a slot. A slot gives three adaptive
// probabilities: its own, one selected by the last bits seen in the slot, and one selected by the last byte
// seen there. The last two are in tables that all slots of a context share. There is one such table for each
// phase of the parser.
//
// The inputs are ln(p / (1 - p)) of each probability p, and p - 1/2 of the slot's own. One more input comes
// from the marks at the possible targets of an operand (x86_tracker.h), and one is constant. Eight sets of
// weights mix all inputs. Each set has many rows, and one is selected by the set's own fields and by bits of
// the byte. A ninth set, whose row the phase selects, mixes the eight results. A last table, also selected by
// fields and bits, corrects the mixed probability. The error trains the weights of each row, more slowly the
// more often the row was used.
//
// This is the definition. stub.S does the same in fewer bytes, and the packer runs both before it writes
// anything. They must agree to the last bit: single-precision floats, one operation at a time in the order
// written, not contracted, sums in four lanes; contexts and counters in order, because slots may collide.
#pragma once

#include "packer/model/x86_tracker.h"

namespace pack {

constexpr uint32_t kContextCounters = 3;
constexpr uint32_t kMostContexts = 16; // 24 saved nothing
constexpr uint32_t kSets = 8;
constexpr uint32_t kRowBits = 14, kRows = 1 << kRowBits; // rows of a set's weights
constexpr uint32_t kLeastSlotBits = 12, kMostSlotBits = 23;

// What the packer chooses for each program.
struct ModelParameters {
    uint32_t contexts; // a multiple of four, 4 .. kMostContexts
    uint32_t slotBits; // 2^slotBits slots of eight bytes
    // The fields of each context, a bit for each field from kColumn on; then the fields of the selectors of
    // all sets but the first. [0] is for code, [1] for data
    uint32_t masks[2][kMostContexts + kSets - 1];

    bool operator==(const ModelParameters &other) const {
        bool same = contexts == other.contexts && slotBits == other.slotBits;
        for (uint32_t i = 0; same && i < hashes(); ++i)
            same = masks[0][i] == other.masks[0][i] && masks[1][i] == other.masks[1][i];
        return same;
    }
    uint32_t hashes() const { return contexts + kSets - 1; }
    uint32_t inputs4() const { return 1 + contexts; } // vectors of four inputs: see Model
    bool sane(const MayUse &mayUse = kMayUse) const {
        uint32_t unknown = 0; // fields that contexts may not use
        for (int type = 0; type < 2; ++type)
            for (uint32_t mask : masks[type]) unknown |= mask & ~mayUse[type];
        return contexts >= 4 && contexts <= kMostContexts && contexts % 4 == 0 &&
               slotBits >= kLeastSlotBits && slotBits <= kMostSlotBits && !unknown;
    }
};

// The upper 24 bits are a signed probability: -kHalf .. kHalf stands for 0 .. 1. The lower 8 bits count the
// bits that the counter has seen, up to 255. Zeroed memory is a counter that has seen nothing.
typedef uint32_t Counter;
constexpr int32_t kSeenBits = 8, kProbabilityBits = 24;
constexpr int32_t kHalf = 1 << (kProbabilityBits - 1), kCertain = kHalf - 1;
// A counter moves by 1 / (seen + settled) of its error: least the third one, which the last byte selects
constexpr float kSettled[kContextCounters] = {1.05f, 1.3f, 1.4f};
constexpr int32_t kShareBits = 20; // bits of the probability that predict() returns

struct Slot {
    Counter counter;
    uint8_t history;  // a leading one, then the last bits seen, up to seven; the lowest bit is inverted
    uint8_t lastByte; // the last byte seen here; only in the slot of a byte's first bit
    uint16_t check;   // the low bits of the hash that the slot belongs to
};

constexpr uint32_t kHistoryFull = 128; // the leading one of a history of seven bits

typedef float Float4 __attribute__((vector_size(16)));
typedef int32_t Int4 __attribute__((vector_size(16)));
// Logarithms are in units of a float's last bit: 2^23 for a factor of 2.
constexpr float kLogUnit = 0.69314718f / (1 << 23);
constexpr float kConstant = 1 << 25; // the constant input
constexpr float kFirstWeight = 1.0f / 25, kFinalLearning = 1.0f / 1250 * kLogUnit;
// The rate of a row that was used n times: kLearning + kEarlyLearning / (n + kEarlyUses)
constexpr float kLearning = 0.0035f * kLogUnit, kEarlyUses = 75,
                kEarlyLearning = 0.019f * kLogUnit * kEarlyUses;
constexpr int32_t kLinearShift = 2;       // scales the input p - 1/2: 1/2 is kHalf << kLinearShift
constexpr int32_t kOddsShift = 2;         // scales the logarithm of Odds
constexpr float kMostSum = 11 / kLogUnit; // a weighted sum is limited to -kMostSum .. kMostSum
// Corrections: a hash selects one of 16,384 rows, and the weighted sum selects one of the row's 32 counters.
// A factor of e in the odds is 1.25 counters
constexpr uint32_t kCorrectionRowBits = 14, kCorrectionBits = 5;
constexpr float kSteepness = 1.25f * kLogUnit, kMiddle = 1 << (kCorrectionBits - 1);
constexpr uint32_t kFirstTrust = 14; // a new correction starts as if it had seen this many bits

// The hash of a nibble selects 64 adjacent slots: four for each of its fifteen steps, and four unused ones.
// The nibble's bits so far select the step. (In the stub, all slots of one way are adjacent.)
struct Nibble {
    // Both are a leading one, then bits: those before the nibble, and the nibble's so far (step: 1 .. 15)
    uint32_t start, step;
    uint32_t number() const { return start ^ 16; } // 17 for the first nibble, 0 .. 15 for the second
};
inline Nibble nibbleOf(uint32_t bits) {
    uint32_t coded = (uint32_t)(31 - __builtin_clz(bits)) & 3, start = bits >> coded;
    return {start, bits - ((start - 1) << coded)};
}
constexpr uint32_t kNibbles = 18, kNibbleSlots = 16, kWays = 4;

// The counters that all slots of a context share. Each phase of the parser has a table: first the counters
// that the history selects, then the counters that nibble, last byte and step select. To save memory, each
// table begins before the previous one ends, and both use the counters in common. The histories are used
// often, so they overlap a part that is rarely used: last bytes of 0x70 to 0x7f, in bytes whose high
// nibble is 9.
constexpr uint32_t kHistories = 256, kAfterByte = 256 * kNibbleSlots;
constexpr uint32_t kPhaseCounters = kHistories + 9 * kAfterByte + 0x70 * kNibbleSlots;
constexpr uint32_t kSharedCounters = (kPhases - 1) * kPhaseCounters + kHistories + kNibbles * kAfterByte;

struct Context {
    Slot *slot, *byteSlot; // the slots of this bit and of this byte's first bit
    Counter *counter[kContextCounters];
    Counter shared[kSharedCounters]; // shared by all slots
};

struct alignas(64) Model {
    // Inputs: the odds, the constant and two zeros; then four of each context: one of each counter, and the
    // slot's p - 1/2. In a row of weights, [0][3] is not a weight: it counts how often the row was used
    Float4 inputs[1 + kMostContexts], results[kSets / 4];
    Float4 *rows[kSets];
    Counter *correction;
    float mixed;
    uint32_t phase; // the parser's phase at this byte
    uint32_t hashes[kMostContexts + kSets - 1];
    Context contexts[kMostContexts];
    uint8_t opcodes[kOpcodes];
    Counter corrections[1 << kCorrectionRowBits][1 << kCorrectionBits];
    Float4 finalWeights[kPhases][kSets / 4], weights[kSets][kRows][1 + kMostContexts];
};

// Returns ln(x) in units of kLogUnit plus a constant: the bits of a float are piecewise linear in it.
inline Int4 logBits(Int4 x) { return (Int4) __builtin_convertvector(x, Float4); }

// Returns a context's inputs: ln(p / (1 - p)) of its counters, and p - 1/2 of the first one.
inline Float4 inputsOf(Counter *const *c) {
    Int4 p = Int4{(int32_t)*c[0], (int32_t)*c[1], (int32_t)*c[2], 0} >> kSeenBits;
    Int4 inputs = logBits(kCertain + 2 + p) - logBits(kCertain + 2 - p);
    inputs[3] = p[0] * (1 << kLinearShift);
    return __builtin_convertvector(inputs, Float4);
}
inline float logOf(Odds odds) {
    Int4 logs = logBits(Int4{(int32_t)odds.ones, (int32_t)odds.zeros});
    return (float)((logs[0] - logs[1]) * (1 << kOddsShift));
}
// The inverse: returns p for x = ln(p / (1 - p)), with the same piecewise linear curve.
inline float squash(float x) {
    float odds = __builtin_bit_cast(float, (int32_t)x + __builtin_bit_cast(int32_t, 1.0f));
    return odds / (odds + 1);
}

inline float mix(const Float4 *weights, const Float4 *inputs, uint32_t count4) {
    Float4 sums = {};
    while (count4--) sums += weights[count4] * inputs[count4];
    float sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    return sum > kMostSum ? kMostSum : sum < -kMostSum ? -kMostSum : sum;
}

inline void train(Float4 *weights, const Float4 *inputs, uint32_t count4, float by) {
    while (count4--) weights[count4] += inputs[count4] * by;
}

constexpr uint32_t kMostSeen = (1 << kSeenBits) - 1;
inline uint32_t seenBy(Counter c) { return c & kMostSeen; }

inline void adapt(Counter &c, uint32_t bit, float settled) {
    int32_t p = (int32_t)c >> kSeenBits;
    uint32_t seen = seenBy(c);
    p += (int32_t)((float)((bit ? kCertain : ~kCertain) - p) / ((float)(int32_t)seen + settled));
    c = (uint32_t)p << kSeenBits | (seen + (seen < kMostSeen));
}

// Returns the hash of the fields that context i uses, in code (type 0) or data (1). After the contexts, i
// counts the selectors of the sets, from the second set on.
inline uint32_t hashOf(const ModelParameters &parameters, uint32_t type, uint32_t i, const uint32_t *fields) {
    uint32_t hash = mixIn(parameters.hashes() - i + type, fields[kParserState]),
             mask = parameters.masks[type][i];
    for (uint32_t j = kColumn; mask; mask >>= 1, ++j)
        if (mask & 1) hash = mixIn(hash, fields[j]);
    return hash;
}

inline uint32_t phaseOf(const uint32_t *fields) { return fields[kParserState] & ((1 << kPhaseBits) - 1); }

inline Slot *nibbleSlots(Slot *slots, uint32_t slotBits, uint32_t hash) {
    return slots + (hash >> (32 - slotBits) & ~(kWays * kNibbleSlots - 1));
}

// Finds a context's counters. `hash`: the hash of the nibble.
inline void findCounters(Context &c, Slot *slots, uint32_t slotBits, uint32_t hash, uint32_t phase,
                         Nibble nibble) {
    uint16_t check = (uint16_t)hash;
    Slot *ways = nibbleSlots(slots, slotBits, hash);
    ways += (hash >> (32 - slotBits) ^ nibble.step) % kNibbleSlots * kWays;
    Slot *s = ways, *worst = s;
    for (; s < ways + kWays && s->check != check; ++s)
        if (seenBy(s->counter) < seenBy(worst->counter)) worst = s;
    if (s == ways + kWays) *(s = worst) = Slot{0, 0, 0, check}; // replaces the slot that has seen least
    c.slot = s;
    if (nibble.start == 1 && nibble.step == 1) c.byteSlot = s;
    Counter *shared = c.shared + phase * kPhaseCounters;
    c.counter[0] = &s->counter;
    c.counter[1] = shared + s->history;
    shared += kHistories + nibble.number() * kAfterByte + nibble.step;
    c.counter[2] = shared + c.byteSlot->lastByte * kNibbleSlots;
}

inline void learn(Context &c, uint32_t bit) {
    for (uint32_t k = 0; k < kContextCounters; ++k) adapt(*c.counter[k], bit, kSettled[k]);
    uint8_t &history = c.slot->history;
    uint32_t h = history ^ 1u;
    if (h & kHistoryFull) h = (h & (kHistoryFull / 2 - 1)) | kHistoryFull / 2; // drops the oldest bit
    history = (uint8_t)((h * 2 + bit) ^ 1);
}

// Returns the number of the row of weights that a set uses. It comes from the hash of the set's selector and
// some bits of the byte so far; in the first set, from the phase and all bits so far.
inline uint32_t rowOf(uint32_t set, uint32_t hash, uint32_t phase, uint32_t bits) {
    return set ? hash >> (32 - kRowBits) ^ bits >> ((kSets + 1 - set) | 4) : phase << 8 | bits;
}

// Begins a byte in code (type 0) or data (1).
inline void beginByte(Model &m, const ModelParameters &parameters, const uint32_t *fields, uint32_t type) {
    for (uint32_t i = 0; i < parameters.hashes(); ++i) m.hashes[i] = hashOf(parameters, type, i, fields);
    m.phase = phaseOf(fields);
}

// Returns the probability that the next bit is a one, in units of 2^-kShareBits: 1 .. 2^kShareBits - 1.
// `bits`: a leading one, then the byte's bits so far.
inline uint32_t predict(Model &m, const ModelParameters &parameters, Slot *slots, uint32_t bits, Odds odds) {
    Nibble nibble = nibbleOf(bits);
    if (nibble.step == 1)
        for (uint32_t i = 0; i < parameters.contexts; ++i) {
            m.hashes[i] = mixIn(m.hashes[i], nibble.start); // from now on the hash of the nibble
            // Most of the time is spent waiting for memory, so load all slots of a nibble at once.
            // WebAssembly has no prefetch: an unused load has the same effect
            const Slot *s = nibbleSlots(slots, parameters.slotBits, m.hashes[i]);
            for (uint32_t k = 0; k < kWays * kNibbleSlots; k += 64 / sizeof(Slot))
                asm volatile("" ::"r"(s[k].counter));
        }
    for (uint32_t i = 0; i < parameters.contexts; ++i)
        findCounters(m.contexts[i], slots, parameters.slotBits, m.hashes[i], m.phase, nibble);
    float *results = (float *)m.results;
    m.inputs[0] = Float4{logOf(odds), kConstant, 0, 0};
    for (uint32_t i = 0; i < parameters.contexts; ++i) m.inputs[1 + i] = inputsOf(m.contexts[i].counter);

    // Mix. The results are in reverse order of the sets
    for (uint32_t i = 0; i < kSets; ++i) {
        m.rows[i] = m.weights[i][rowOf(i, m.hashes[parameters.contexts + i - 1], m.phase, bits)];
        results[kSets - 1 - i] = mix(m.rows[i], m.inputs, parameters.inputs4());
    }
    float sum = mix(m.finalWeights[m.phase], m.results, kSets / 4);
    m.mixed = squash(sum);

    // Correct
    m.correction = m.corrections[mixIn(m.hashes[parameters.contexts], bits) >> (32 - kCorrectionRowBits)] +
                   (int32_t)(sum * kSteepness + kMiddle);
    int32_t p = (int32_t)(m.mixed * (1 << kProbabilityBits));
    if (!*m.correction) *m.correction = (uint32_t)(p - kHalf) << kSeenBits | kFirstTrust;
    // The mean of three parts of the mixed probability and one part of the corrected one
    int32_t four = ((int32_t)*m.correction >> kSeenBits) + kHalf + 3 * p;
    return (uint32_t)four >> (kProbabilityBits + 2 - kShareBits) | 1;
}

inline void learn(Model &m, const ModelParameters &parameters, uint32_t bit) {
    float y = (float)(int32_t)bit;
    const float *results = (const float *)m.results;
    for (uint32_t i = 0; i < kSets; ++i) {
        float &used = ((float *)m.rows[i])[3], rate = kEarlyLearning / (used + kEarlyUses) + kLearning;
        used += 1;
        train(m.rows[i], m.inputs, parameters.inputs4(), (y - squash(results[kSets - 1 - i])) * rate);
    }
    train(m.finalWeights[m.phase], m.results, kSets / 4, (y - m.mixed) * kFinalLearning);
    for (uint32_t i = 0; i < parameters.contexts; ++i) learn(m.contexts[i], bit);
    adapt(*m.correction, bit, kSettled[0]);
}

// Ends a byte, whose value is `byte`.
inline void endByte(Model &m, const ModelParameters &parameters, uint8_t byte) {
    for (uint32_t i = 0; i < parameters.contexts; ++i) m.contexts[i].byteSlot->lastByte = byte;
}

} // namespace pack

#include "packer/report/deflate.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <queue>

namespace pack {

namespace {

constexpr uint32_t kWindow = 32768, kShortest = 3, kLongest = 258, kTries = 96, kHashBits = 15;
constexpr uint32_t kLiterals = 286, kDistances = 30, kEndOfBlock = 256, kLongestCode = 15, kBlock = 1 << 16;

// A byte, or what stands for a copy of earlier bytes.
struct Token {
    uint32_t value; // of the byte, or the copy's length
    uint32_t distance = 0;
};

// --- Finding what repeats ---

class Matcher {
public:
    explicit Matcher(const std::vector<uint8_t> &b)
        : bytes(b), first(1u << kHashBits, kNone), next(kWindow) {}
    // The longest copy for what stands at `at`, at least kShortest; otherwise the byte.
    Token find(uint32_t at) const {
        Token best = {bytes[at]};
        uint32_t most = (uint32_t)std::min<size_t>(kLongest, bytes.size() - at), length = kShortest - 1;
        if (most < kShortest) return best;
        uint32_t from = first[hash(at)];
        for (uint32_t tries = 0; from != kNone && at - from <= kWindow && tries < kTries; ++tries) {
            uint32_t same = 0;
            while (same < most && bytes[from + same] == bytes[at + same]) ++same;
            if (same > length) {
                length = same;
                best = {length, at - from};
                if (same == most) break;
            }
            uint32_t before = next[from % kWindow];
            if (before >= from) break; // overwritten, or kNone
            from = before;
        }
        return best;
    }
    void add(uint32_t at) {
        if (at + kShortest > bytes.size()) return;
        uint32_t &slot = first[hash(at)];
        next[at % kWindow] = slot;
        slot = at;
    }

private:
    static constexpr uint32_t kNone = UINT32_MAX;
    uint32_t hash(uint32_t at) const {
        uint32_t three = bytes[at] | bytes[at + 1] << 8 | (uint32_t)bytes[at + 2] << 16;
        return three * 0x9E3779B1u >> (32 - kHashBits);
    }
    const std::vector<uint8_t> &bytes;
    std::vector<uint32_t> first, next; // the last place with a hash, and the one before each
};

std::vector<Token> tokens(const std::vector<uint8_t> &bytes) {
    Matcher matcher(bytes);
    std::vector<Token> all;
    for (uint32_t at = 0; at < bytes.size();) {
        Token token = matcher.find(at);
        matcher.add(at);
        // A byte, if a longer copy begins behind it
        if (token.distance && at + 1 < bytes.size()) {
            Token later = matcher.find(at + 1);
            if (later.distance && later.value > token.value) token = {bytes[at]};
        }
        all.push_back(token);
        uint32_t end = at + (token.distance ? token.value : 1);
        while (++at < end) matcher.add(at);
    }
    return all;
}

// --- Codes ---

// The number of a code, and the bits that follow it.
struct Symbol {
    uint32_t code, extra, extraBits;
};
// Four codes (two for distances) for each power of two, the first ones without extra bits.
Symbol symbolOf(uint32_t value, uint32_t codesEach) {
    if (value < 2 * codesEach) return {value, 0, 0};
    auto bits = (uint32_t)std::bit_width(value / codesEach) - 1;
    return {codesEach * bits + (value >> bits), value & ((1u << bits) - 1), bits};
}
Symbol lengthSymbol(uint32_t length) {
    if (length == kLongest) return {285, 0, 0};
    Symbol s = symbolOf(length - kShortest, 4);
    return {257 + s.code, s.extra, s.extraBits};
}

// Huffman's lengths of codes; 0 for what does not occur.
std::vector<uint8_t> codeLengths(std::vector<uint64_t> counts) {
    struct Node {
        uint64_t count;
        size_t left, right; // itself, in a leaf
    };
    for (;;) {
        std::vector<Node> nodes;
        auto rarer = [&](size_t a, size_t b) { return nodes[a].count > nodes[b].count; };
        std::priority_queue<size_t, std::vector<size_t>, decltype(rarer)> queue(rarer);
        for (size_t i = 0; i < counts.size(); ++i) {
            nodes.push_back({counts[i], i, i});
            if (counts[i]) queue.push(i);
        }
        size_t used = queue.size();
        while (queue.size() > 1) {
            size_t a = queue.top();
            queue.pop();
            size_t b = queue.top();
            queue.pop();
            nodes.push_back({nodes[a].count + nodes[b].count, a, b});
            queue.push(nodes.size() - 1);
        }
        // Parents stand behind their children
        std::vector<uint32_t> depth(nodes.size());
        for (size_t i = nodes.size(); i-- > counts.size();)
            depth[nodes[i].left] = depth[nodes[i].right] = depth[i] + 1;
        if (used == 1) depth[queue.top()] = 1;
        depth.resize(counts.size());
        if (*std::max_element(depth.begin(), depth.end()) <= kLongestCode)
            return {depth.begin(), depth.end()};
        for (uint64_t &c : counts)
            if (c) c = c / 2 + 1; // closer to each other, so less deep
    }
}

// Codes of these lengths in order, with their first bit lowest, as they are written.
std::vector<uint32_t> codes(const std::vector<uint8_t> &lengths) {
    std::vector<uint32_t> all(lengths.size());
    uint32_t code = 0;
    for (uint32_t length = 1; length <= kLongestCode; ++length, code <<= 1)
        for (size_t i = 0; i < lengths.size(); ++i)
            if (lengths[i] == length) {
                for (uint32_t bit = 0; bit < length; ++bit) all[i] |= (code >> bit & 1) << (length - 1 - bit);
                ++code;
            }
    return all;
}

class Writer {
public:
    explicit Writer(std::vector<uint8_t> &o) : out(o) {}
    void bits(uint32_t value, uint32_t number) {
        pending |= (uint64_t)value << filled;
        for (filled += number; filled >= 8; filled -= 8, pending >>= 8) out.push_back((uint8_t)pending);
    }
    void finish() {
        if (filled) bits(0, 8 - filled);
    }

private:
    std::vector<uint8_t> &out;
    uint64_t pending = 0;
    uint32_t filled = 0;
};

// The bits of a code in each of the two alphabets.
struct Alphabet {
    std::vector<uint8_t> lengths;
    std::vector<uint32_t> codes;
    explicit Alphabet(const std::vector<uint64_t> &counts)
        : lengths(codeLengths(counts)), codes(pack::codes(lengths)) {}
    void write(Writer &writer, const Symbol &s) const {
        writer.bits(codes[s.code], lengths[s.code]);
        writer.bits(s.extra, s.extraBits);
    }
};

// A block with codes of its own. Their lengths are written as they are, in four bits: the code of lengths has
// all of 0 to 15, and no repetitions.
void writeBlock(Writer &writer, const Token *from, const Token *to, bool last) {
    std::vector<uint64_t> literals(kLiterals), distances(kDistances);
    literals[kEndOfBlock] = 1;
    for (const Token *t = from; t != to; ++t)
        if (t->distance) {
            ++literals[lengthSymbol(t->value).code];
            ++distances[symbolOf(t->distance - 1, 2).code];
        } else
            ++literals[t->value];
    Alphabet literal(literals), distance(distances);
    writer.bits(last, 1);
    writer.bits(2, 2);
    writer.bits(kLiterals - 257, 5);
    writer.bits(kDistances - 1, 5);
    writer.bits(19 - 4, 4);
    for (int i = 0; i < 19; ++i) writer.bits(i < 3 ? 0 : 4, 3); // 16 to 18 stand first
    for (const Alphabet *a : {&literal, &distance})
        for (uint8_t length : a->lengths)
            for (int bit = 3; bit >= 0; --bit) writer.bits(length >> bit & 1, 1);
    for (const Token *t = from; t != to; ++t)
        if (t->distance) {
            literal.write(writer, lengthSymbol(t->value));
            distance.write(writer, symbolOf(t->distance - 1, 2));
        } else
            literal.write(writer, {t->value, 0, 0});
    literal.write(writer, {kEndOfBlock, 0, 0});
}

} // namespace

std::vector<uint8_t> deflate(const std::vector<uint8_t> &bytes) {
    std::vector<uint8_t> out = {0x78, 0x9c};
    std::vector<Token> all = tokens(bytes);
    Writer writer(out);
    size_t at = 0;
    do {
        size_t to = std::min<size_t>(all.size(), at + kBlock);
        writeBlock(writer, all.data() + at, all.data() + to, to == all.size());
        at = to;
    } while (at < all.size());
    writer.finish();
    uint32_t a = 1, b = 0; // Adler's checksum
    for (uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    for (uint32_t part : {b >> 8, b, a >> 8, a}) out.push_back((uint8_t)part);
    return out;
}

std::string base64(const std::vector<uint8_t> &bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        size_t n = std::min<size_t>(3, bytes.size() - i);
        uint32_t three = 0;
        for (size_t j = 0; j < 3; ++j) three = three << 8 | (j < n ? bytes[i + j] : 0);
        for (size_t j = 0; j < 4; ++j) text += j <= n ? kDigits[three >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

} // namespace pack

#include "packer/model/estimate.h"
#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/write/packed_file.h"
#include "tests/support/sanitized.h"
#include "tests/support/thrown.h"

#include <iterator>

using namespace pack;

static Bytes randomBytes(size_t size, unsigned seed, int alphabet = 256) {
    std::mt19937 random(seed);
    Bytes b(size);
    for (uint8_t &x : b) x = (uint8_t)(random() % (unsigned)alphabet);
    return b;
}

// Real machine code, from this test program.
static Bytes realCode(size_t size) {
    Bytes all = readBytes("/proc/self/exe");
    size_t from = all.size() / 3;
    return {all.begin() + (long)from, all.begin() + (long)(from + size)};
}

static Layout allCode(const Bytes &b) { return {(uint32_t)b.size(), 0, (uint32_t)b.size()}; }

// Parameters with little memory, so that thousands of runs are fast.
static ModelParameters smallParameters(uint32_t slotBits = 14) {
    ModelParameters parameters = defaultParameters();
    parameters.slotBits = slotBits;
    return parameters;
}

static void shuffleMasks(ModelParameters &parameters, std::mt19937 &random) {
    for (int type = 0; type < 2; ++type)
        for (uint32_t i = 0; i < parameters.hashes(); ++i)
            parameters.masks[type][i] = (uint32_t)random() & kMayUse[type];
}

// Makes a packed file with a payload.
static Bytes fileAround(const Bytes &payload, const Layout &layout, const ModelParameters &parameters) {
    Program program = {};
    program.base = 0x400000;
    program.span = 1 << 20;
    program.early = kNothingEarly;
    program.slots[0] = program.base;
    program.slots[1] = program.base + 8;
    program.bytes.resize(layout.size);
    program.codeBegin = layout.codeBegin;
    program.codeSize = layout.codeSize;
    return kElf.write(program, parameters, payload, {});
}

// Encodes, and expects the same bytes from the C++ decoder and from the stub's.
static void expectDecoded(const Bytes &b, const Layout &layout, const ModelParameters &parameters) {
    Encoded e = encode(b, layout, parameters);
    ASSERT_EQ(decode(e.payload, layout, parameters), b) << b.size();
    if (b.empty()) return;
    ASSERT_EQ(decodeWithStub(kElf, fileAround(e.payload, layout, parameters)), b) << b.size();
}

// Random opcodes with random operands, many of them extreme.
static Bytes structured(unsigned seed, size_t size) {
    std::mt19937 random(seed);
    static const Bytes starts[] = {{0xe8},
                                   {0xe9},
                                   {0x0f, 0x84},
                                   {0x48, 0x8d, 0x05},
                                   {0xc5, 0xf8, 0x28, 0x05},
                                   {0xc4, 0xe2, 0x7d, 0x18, 0x0d},
                                   {0x48, 0xb8},
                                   {0x66, 0xc7, 0x05},
                                   {0xf7, 0x05},
                                   {0x0f, 0x3a, 0x0f, 0x04, 0x25},
                                   {0x66, 0xe8},
                                   {0x66, 0x0f, 0x85}};
    Bytes b;
    while (b.size() < size) {
        if (random() % 3) {
            const Bytes &s = starts[random() % std::size(starts)];
            b.insert(b.end(), s.begin(), s.end());
        } else
            b.push_back((uint8_t)random());
        uint32_t at = (uint32_t)b.size();
        const uint32_t edges[] = {0,          1,       0xffffffff,  0x7fffffff,
                                  0x80000000, 0u - at, 0u - at - 4, (uint32_t)random()};
        uint32_t value = edges[random() % 8];
        for (int i = 0; i < 4; ++i) b.push_back((uint8_t)(value >> 8 * i));
    }
    b.resize(size);
    return b;
}

// --- Parser and filter ---

TEST(Parser, FindsWhereInstructionsEnd) {
    const Bytes code = {0x55,                                           // push
                        0x48, 0x89, 0xe5,                               // mov
                        0x48, 0x8d, 0x05, 1,    2,    3, 4,             // lea rip
                        0x8b, 0x44, 0x24, 8,                            // mov sib disp8
                        0xc7, 0x84, 0x24, 1,    0,    0, 0, 2, 0, 0, 0, // mov sib disp32 imm32
                        0x48, 0xb8, 1,    2,    3,    4, 5, 6, 7, 8,    // mov imm64
                        0x66, 0xb8, 1,    2,                            // mov imm16
                        0xf6, 0xc1, 4,                                  // test imm8
                        0xf7, 0xd8,                                     // neg
                        0x0f, 0x84, 1,    0,    0,    0,                // je
                        0xe8, 1,    0,    0,    0,                      // call
                        0xc5, 0xf8, 0x77,                               // vzeroupper
                        0xc5, 0xfc, 0x28, 0x05, 1,    2, 3, 4,          // vmovaps rip
                        0xc4, 0xe2, 0x7d, 0x18, 0x45, 8,                // vbroadcastss
                        0xc4, 0xe3, 0x7d, 0x18, 0xc1, 1,                // vinsertf128
                        0x66, 0x0f, 0x3a, 0x0a, 0xc0, 9,                // roundss
                        0x0f, 0xb6, 0xc0,                               // movzx
                        0x83, 0x3c, 0x25, 1,    0,    0, 0, 5,          // cmp absolute imm8
                        0x3d, 1,    0,    0,    0,                      // cmp eax
                        0x0f, 0xc2, 0xc1, 2,                            // cmpps
                        0xeb, 5,    0xc3};                              // jmp, ret
    uint8_t opcodes[1024];
    expandOpcodes(opcodes);
    X86Parser parser = {};
    uint32_t fields[kFields] = {};
    std::vector<int> lengths = {0};
    for (uint8_t b : code) {
        parser.step(fields, b, opcodes);
        ++lengths.back();
        if (!fields[kSoFar]) lengths.push_back(0);
    }
    EXPECT_EQ(lengths,
              (std::vector<int>{1, 3, 7, 4, 11, 10, 4, 3, 2, 6, 5, 3, 8, 6, 6, 6, 3, 8, 5, 4, 2, 1, 0}));
}

TEST(Filter, MakesOneTargetLookTheSame) {
    // Calls, a jump, and two loads from 0x30; one of these has an immediate operand after the displacement
    Bytes code;
    auto add = [&](Bytes opcode, Bytes tail) {
        size_t at = code.size() + opcode.size();
        uint32_t displacement = 0x30 - (uint32_t)(at + 4 + tail.size());
        code.insert(code.end(), opcode.begin(), opcode.end());
        for (int i = 0; i < 4; ++i) code.push_back((uint8_t)(displacement >> 8 * i));
        code.insert(code.end(), tail.begin(), tail.end());
        return at;
    };
    std::vector<size_t> operands = {
        add({0xe8}, {}),        add({0x0f, 0x85}, {}),           add({0xf3, 0x0f, 0x10, 0x05}, {}),
        add({0x83, 0x3d}, {7}), add({0xc7, 0x05}, {1, 2, 3, 4}), add({0xe9}, {})};
    Bytes f = filter(code, allCode(code));
    for (size_t at : operands)
        EXPECT_EQ(Bytes(f.begin() + (long)at, f.begin() + (long)at + 4), (Bytes{0, 0, 0, 0x30}));
}

// --- Model and coder: the C++ decoder and the stub's decoder against the encoder ---

TEST(Coder, BothDecodersGiveBackWhatWasEncoded) {
    std::vector<Bytes> all = {{}, {0}, {255}, {0xe8}, Bytes(20000, 0), Bytes(5000, 0xe8), realCode(10000)};
    for (unsigned i = 0; i < 10; ++i) {
        all.push_back(randomBytes(i * 74, i, i % 2 ? 256 : 3));
        all.push_back(structured(i, i * 58));
    }
    for (unsigned i = 0; i < 40; ++i) all.push_back(i % 2 ? structured(i, i) : randomBytes(i, i));
    std::mt19937 random(5);
    for (const Bytes &b : all) {
        Layout layout = allCode(b);
        if (!b.empty() && random() % 2) {
            layout.codeBegin = random() % layout.size;
            layout.codeSize = random() % (layout.size - layout.codeBegin + 1);
        }
        ModelParameters parameters = smallParameters(12 + random() % 6);
        parameters.contexts = 4 * (1 + random() % (kMostContexts / 4));
        shuffleMasks(parameters, random);
        expectDecoded(b, layout, parameters);
    }
}

TEST(Coder, CountsTheBitsOfEachByte) {
    Bytes b = realCode(8000);
    Encoded e = encode(b, allCode(b), smallParameters());
    EXPECT_NEAR(e.size(), (double)e.payload.size(), 8);
}

TEST(Coder, CompressesWhatHasStructure) {
    auto size = [](const Bytes &b) {
        return encode(b, {(uint32_t)b.size(), 0, 0}, defaultParameters()).payload.size();
    };
    EXPECT_LT(size(Bytes(20000, 0)), 100u);
    EXPECT_LT(size(randomBytes(10000, 1, 4)), 10000u / 4 * 1.06);
    EXPECT_LT(size(randomBytes(2000, 1)), 2000u * 1.06);
}

// The range is smallest if the very last bit is the unlikely one. Nearly certain but wrong bits make carries
// run through the whole output.
TEST(Coder, SurvivesSurprises) {
    for (uint32_t size : {300, 3000})
        for (uint8_t fill : {0x00, 0x55, 0xff})
            for (uint32_t middle : {0u, size / 2}) {
                Bytes b(size, fill);
                b.back() ^= 1;
                if (middle) b[middle] = 0x7f;
                expectDecoded(b, {size, 0, middle ? size : 0}, smallParameters());
            }
}

// A packed file has no bits for fields that contexts may not use.
TEST(Coder, RefusesMasksOfFieldsThatCannotBeUsed) {
    for (int type = 0; type < 2; ++type)
        for (uint32_t bit = 0; bit < 32; ++bit) {
            ModelParameters parameters = smallParameters();
            parameters.masks[type][3] = 1u << bit;
            EXPECT_EQ(parameters.sane(), kMayUse[type] >> bit & 1) << type << " " << bit;
        }
}

TEST(Coder, KeepsMasksInAFile) {
    Bytes b = randomBytes(100, 1);
    ModelParameters parameters = smallParameters();
    std::mt19937 random(1);
    shuffleMasks(parameters, random);
    Layout layout = {100, 0, 0};
    Bytes file = fileAround(encode(b, layout, parameters).payload, layout, parameters);
    EXPECT_EQ(kElf.open(file).parameters, parameters);
    EXPECT_EQ(readPacked(kElf, file).bytes, b);
}

// --- Model parameters and search ---

TEST(ModelParameters, ArePrintedAndParsed) {
    auto complaint = [](const std::string &text) {
        return thrown<common::Refused>([&] { parseParameters(text); });
    };
    std::string text = printParameters(defaultParameters());
    EXPECT_EQ(parseParameters(text), defaultParameters());
    EXPECT_NE(complaint(""), "");
    EXPECT_EQ(complaint("slots many\n"), "line 1: slots needs a number of bits");
    EXPECT_EQ(complaint("code byte1\ncode byte9\n"), "line 2: unknown field in 'byte9'");
    EXPECT_EQ(complaint("data byte1+opcode+mode\n"), "line 1: 'opcode+mode' cannot be used in data");
    EXPECT_EQ(complaint("code-weights column\n"), "line 1: 'column' cannot be used in code");
    EXPECT_EQ(complaint("kode byte1\n"), "line 1: unknown word 'kode'");
    EXPECT_EQ(complaint("code byte1 byte2\n"), "line 1: a word and its value are needed");
    EXPECT_EQ(complaint("slots 20\nslots 21\n"), "line 2: slots is given twice");
    EXPECT_NE(complaint(text + "code byte1\n"), "");
    EXPECT_NE(complaint(text + "data-weights byte1\n"), "");
    text.replace(text.find("slots 2"), 7, "slots 9");
    EXPECT_NE(complaint(text), "");
}

// Tests code, data and both, with several numbers of contexts.
TEST(Estimates, AreNearTheMeasuredSize) {
    Bytes b = realCode(8000);
    uint32_t count = (uint32_t)b.size();
    const struct {
        Layout layout;
        uint32_t contexts;
    } kCases[] = {{{count, 0, count}, 4}, {{count, 0, 0}, 12}, {{count, 1500, 5000}, 16}};
    for (auto [layout, contexts] : kCases) {
        if (kSanitized && contexts != 4) continue;
        Bytes filtered = filter(b, layout);
        ModelParameters parameters = smallParameters(20);
        parameters.contexts = contexts;
        for (int type = 0; type < 2; ++type)
            for (uint32_t i = 12; i < parameters.hashes(); ++i)
                parameters.masks[type][i] = 7u << i % (kChoices - 2) & kMayUse[type];
        Estimator estimator(byteRecords(filtered, layout));
        Estimate first = estimator(parameters);
        double size = encode(b, layout, parameters).size();
        EXPECT_NEAR(first.bytes, size, size * 0.01) << contexts;

        // Reusing the equal part of another estimate gives the same result
        for (uint32_t i : {1u, contexts, contexts + 3}) {
            ModelParameters other = parameters;
            other.masks[0][i] ^= 0x24;
            other.masks[1][i] ^= 0x24;
            Estimate reused = estimator(other, &first), alone = estimator(other);
            EXPECT_DOUBLE_EQ(reused.bytes, alone.bytes);
            size = encode(b, layout, other).size();
            EXPECT_NEAR(reused.bytes, size, size * 0.01) << contexts << " " << i;
            EXPECT_EQ(estimator(other, &first, -1e9).bytes, kTooMany);
        }
    }
}

TEST(Search, KeepsTheBest) {
    Bytes b = realCode(3000);
    Layout layout = allCode(b);
    // Four poor contexts, so that any good one saves several times the error of an estimate
    ModelParameters poor = smallParameters(20);
    poor.contexts = 4;
    for (uint32_t i = 0; i < poor.contexts; ++i) poor.masks[0][i] = 0x20000u >> i;
    double before = encode(b, layout, poor).size(), shown = 1e30;
    int tried = 0;
    // Make a hundred tries
    ModelParameters found = search(b, layout, poor, 1e6, [&](const Progress &p) {
        EXPECT_LE(p.bytes, shown);
        shown = p.bytes;
        tried = p.tried;
        return tried < 100;
    });
    double after = encode(b, layout, found).size();
    EXPECT_LT(after, before);
    EXPECT_DOUBLE_EQ(after, shown);
    EXPECT_GE(tried, 100);
    EXPECT_EQ(parseParameters(printParameters(found)), found);
    EXPECT_EQ(search({}, {0, 0, 0}, poor, 1, [](const Progress &) { return true; }), poor);
    // The search can be stopped
    tried = 0;
    search(b, layout, poor, 1000, [&](const Progress &) { return ++tried < 3; });
    EXPECT_LE(tried, 3 + (int)std::thread::hardware_concurrency());
}

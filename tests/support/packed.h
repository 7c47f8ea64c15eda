// Packs programs, and tests what is read back, for tests of all kinds of packed files.
#pragma once

#include "packer/model/model_parameters.h"
#include "packer/write/packed_file.h"

namespace pack {

inline Bytes packed(const PackedKind &kind, const Program &p, const std::string &safeName = "") {
    ModelParameters parameters = defaultParameters();
    return kind.write(p, parameters, encode(p.bytes, p.layout(), parameters).payload, safeName);
}

// Expects that a packed program is decoded by the stub and read back, that a safe name replaces the message
// and nothing else, and that damage is refused: a flipped bit in any byte, and a file cut anywhere. Returns
// the packed file.
inline Bytes expectReadBack(const PackedKind &kind, const Program &p) {
    Bytes file = packed(kind, p), named = packed(kind, p, "plain-one");
    EXPECT_TRUE(isPacked(kind, file) && isPacked(kind, named));
    EXPECT_EQ(decodeWithStub(kind, file), p.bytes);
    for (const Bytes &one : {file, named}) {
        Program back = readPacked(kind, one);
        EXPECT_EQ(back.bytes, p.bytes);
        EXPECT_EQ(back.base, p.base);
        EXPECT_EQ(back.entry, p.entry);
        if (!p.slots[0]) continue; // it imports nothing
        EXPECT_EQ(back.slots[0], p.slots[0]);
        EXPECT_EQ(back.slots[1], p.slots[1]);
    }
    EXPECT_EQ(named.size(), file.size());
    EXPECT_NE(std::string(named.begin(), named.end()).find("use plain-one"), std::string::npos);
    for (size_t i = 0; i < file.size(); ++i) {
        Bytes broken = file;
        broken[i] ^= (uint8_t)(1 << i % 8);
        EXPECT_THROW(readPacked(kind, broken), common::Refused) << i;
        broken.resize(i);
        EXPECT_THROW(readPacked(kind, broken), common::Refused) << i;
    }
    return file;
}

} // namespace pack

// Whole files as bytes. Errors are those of tools/common/whole_file.h.
#pragma once

#include "tools/common/whole_file.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace pack {

using Bytes = std::vector<uint8_t>;

inline Bytes readBytes(const std::string &path) {
    common::WholeFile file = common::readWholeFile(path);
    return {file.view().begin(), file.view().end()};
}

// The permissions of a file, as chmod takes them.
inline unsigned modeOf(const std::string &path) {
    return (unsigned)std::filesystem::status(path).permissions() & 0777;
}

inline void writeBytes(const std::string &path, const Bytes &bytes, unsigned mode = 0) {
    common::writeWhole(path, {(const char *)bytes.data(), bytes.size()}, mode);
}

} // namespace pack

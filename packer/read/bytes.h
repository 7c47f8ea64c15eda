// Whole files as bytes. Errors are those of tools/common/whole_file.h.
#pragma once

#include "tools/common/whole_file.h"

#include <cstdint>
#include <vector>

namespace pack {

using Bytes = std::vector<uint8_t>;

inline Bytes readBytes(const std::string &path) {
    common::WholeFile file = common::readWholeFile(path);
    return {file.view().begin(), file.view().end()};
}

inline void writeBytes(const std::string &path, const Bytes &bytes, bool executable = false) {
    common::writeWhole(path, {(const char *)bytes.data(), bytes.size()}, executable);
}

} // namespace pack

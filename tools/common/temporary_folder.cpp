#include "tools/common/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace common {

TemporaryFolder::TemporaryFolder() {
    std::error_code none;
    std::filesystem::path in = std::filesystem::temp_directory_path(none); // TMPDIR, or /tmp
    std::string name = (none ? "/tmp" : in) / "odraz-XXXXXX";
    if (!mkdtemp(name.data()))
        throw std::runtime_error("cannot make a folder in " + in.string() + ": " + std::strerror(errno));
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

} // namespace common

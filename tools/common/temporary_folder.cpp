#include "tools/common/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace odraz {

TemporaryFolder::TemporaryFolder() {
    char name[] = "/tmp/odraz-XXXXXX";
    if (!mkdtemp(name))
        throw std::runtime_error(std::string("cannot make a folder in /tmp: ") + std::strerror(errno));
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

} // namespace odraz

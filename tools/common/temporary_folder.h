// A new folder in TMPDIR or /tmp. The destructor removes it with all its files.
#pragma once

#include <string>

namespace common {

class TemporaryFolder {
public:
    // Throws std::runtime_error if the folder cannot be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    std::string operator/(const std::string &name) const { return path + "/" + name; }

private:
    std::string path;
};

} // namespace common

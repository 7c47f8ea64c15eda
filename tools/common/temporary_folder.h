// A folder of one's own in /tmp, gone with the object, and with it what lies in it.
#pragma once

#include <string>

namespace odraz {

class TemporaryFolder {
public:
    // Throws std::runtime_error.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    std::string operator/(const std::string &name) const { return path + "/" + name; }

private:
    std::string path;
};

} // namespace odraz

#include "tools/common/folders.h"

#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace common {

NewFolder::NewFolder(std::string named) : path(std::move(named)) {
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    std::error_code wrong;
    bool exists = std::filesystem::exists(path, wrong);
    if (exists && (!std::filesystem::is_directory(path, wrong) || !std::filesystem::is_empty(path, wrong)))
        throw Refused(path + ": already exists: name a new or empty folder");
    if (!exists) checkWritable(path);
    errno = EEXIST;
    for (int i = 0; i < 100 && errno == EEXIST; ++i) {
        part = path + "." + std::to_string(getpid() + i) + ".part";
        if (mkdir(part.c_str(), 0777) == 0) return;
    }
    part.clear();
    fail();
}

NewFolder::~NewFolder() {
    std::error_code ignored;
    if (!part.empty()) std::filesystem::remove_all(part, ignored);
}

void NewFolder::write(const std::string &name, const std::string &text) const {
    writeWhole(part + "/" + name, text);
}

void NewFolder::finish() {
    if (rename(part.c_str(), path.c_str())) fail();
    part.clear();
}

void NewFolder::fail() const {
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
}

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

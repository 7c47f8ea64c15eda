#include "tools/common/whole_file.h"

#include "tools/common/arguments.h"

#include "files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace odraz {

static constexpr long kMostBytes = 4l << 30;

static std::string cannot(const char *what, const std::string &path) {
    return std::string("cannot ") + what + " " + path + ": " + std::strerror(errno);
}

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

// Only a regular file: a device or a pipe may never end, and opening a pipe may take as long.
static OpenFile openRegular(const std::string &path, struct stat &s) {
    if (stat(path.c_str(), &s) == 0 && !S_ISREG(s.st_mode))
        throw Refused("cannot read " + path + ": it is not a regular file");
    OpenFile file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file || fstat(fileno(file.get()), &s) != 0) throw Refused(cannot("read", path));
    std::setvbuf(file.get(), nullptr, _IONBF, 0);
    return file;
}

WholeFile readWholeFile(const std::string &path) {
    struct stat s;
    OpenFile f = openRegular(path, s);
    if (s.st_size > kMostBytes) throw Refused("cannot read " + path + ": it has more than 4 GB");
    auto size = (size_t)s.st_size;
    WholeFile file = {std::make_unique_for_overwrite<char[]>(size), 0};
    file.size = std::fread(file.bytes.get(), 1, size, f.get());
    if (std::ferror(f.get())) throw Refused(cannot("read", path));
    return file;
}

std::string readStart(const std::string &path, size_t size) {
    struct stat s;
    OpenFile f = openRegular(path, s);
    std::string start(size, '\0');
    start.resize(std::fread(start.data(), 1, size, f.get()));
    if (std::ferror(f.get())) throw Refused(cannot("read", path));
    return start;
}

std::string readWhole(const std::string &path) { return std::string(readWholeFile(path).view()); }

void checkWritable(const std::string &path) {
    size_t slash = path.rfind('/');
    std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    if (access(folder.c_str(), W_OK) != 0) throw Refused(cannot("write", path));
}

void writeWhole(const std::string &path, const std::string &text) {
    if (!pack::writeFile(path, text.data(), text.size(), false))
        throw std::runtime_error(cannot("write", path));
}

} // namespace odraz

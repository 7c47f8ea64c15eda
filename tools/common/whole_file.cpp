#include "tools/common/whole_file.h"

#include "tools/common/command_line.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace common {

static constexpr long kMostBytes = 4l << 30;

static std::string cannot(const char *what, const std::string &path) {
    return std::string("cannot ") + what + " " + path + ": " + std::strerror(errno);
}

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

// Regular files only: a device or a pipe may never end, and opening a pipe may block for ever.
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

// The file that a symbolic link leads to, or the path itself.
static std::string targetOf(std::filesystem::path path) {
    std::error_code none;
    for (int i = 0; i < 40 && std::filesystem::is_symlink(path, none); ++i)
        path = path.parent_path() / std::filesystem::read_symlink(path, none);
    return path;
}

void checkWritable(const std::string &given) {
    std::string path = targetOf(given);
    struct stat s;
    bool exists = stat(path.c_str(), &s) == 0;
    if (exists && S_ISDIR(s.st_mode)) throw Refused("cannot write " + path + ": it is a folder");
    size_t slash = path.rfind('/');
    std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    bool direct = exists && !S_ISREG(s.st_mode);
    if (access(direct ? path.c_str() : folder.c_str(), W_OK) != 0) throw Refused(cannot("write", path));
}

// Writes all bytes and closes the file. Returns 0, or what went wrong as errno.
static int writeAndClose(int file, std::string_view bytes) {
    int wrong = 0;
    while (!bytes.empty() && !wrong) {
        ssize_t n = write(file, bytes.data(), bytes.size());
        if (n > 0)
            bytes.remove_prefix((size_t)n);
        else
            wrong = n < 0 ? errno : ENOSPC;
    }
    if (close(file) && !wrong) wrong = errno;
    return wrong;
}

void writeWhole(const std::string &given, std::string_view bytes, unsigned mode) {
    std::string path = targetOf(given);
    struct stat s;
    bool direct = stat(path.c_str(), &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode);
    std::string part = path;
    int file = direct ? open(path.c_str(), O_WRONLY) : -1;
    if (!direct) errno = EEXIST;
    for (int i = 0; i < 100 && file < 0 && errno == EEXIST; ++i) {
        part = path + "." + std::to_string(getpid() + i) + ".part";
        file = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, mode ? mode : 0666);
    }
    if (file < 0) throw std::runtime_error(cannot("write", path));
    if (!direct && mode) fchmod(file, mode); // whatever the umask
    int wrong = writeAndClose(file, bytes);
    if (!direct && !wrong && rename(part.c_str(), path.c_str())) wrong = errno;
    if (!direct && wrong) unlink(part.c_str());
    errno = wrong;
    if (wrong) throw std::runtime_error(cannot("write", path));
}

} // namespace common

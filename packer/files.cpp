#include "packer/files.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pack {

bool readFile(const char *path, std::vector<uint8_t> &bytes) {
    std::FILE *f = std::fopen(path, "rb");
    if (!f) return false;
    uint8_t buffer[65536];
    while (size_t n = std::fread(buffer, 1, sizeof buffer, f)) bytes.insert(bytes.end(), buffer, buffer + n);
    int wrong = std::ferror(f) ? errno : 0;
    std::fclose(f);
    errno = wrong;
    return !wrong;
}

bool writeFile(const std::string &path, const void *bytes, size_t size, bool executable) {
    // A pipe or a device stays where it is and is written to directly
    struct stat s;
    bool stays = stat(path.c_str(), &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode);
    // Otherwise create a new file under a name that no file has yet
    std::string part = path;
    int fd = stays ? open(path.c_str(), O_WRONLY) : -1;
    if (!stays) errno = EEXIST;
    for (int i = 0; i < 100 && fd < 0 && errno == EEXIST; ++i) {
        part = path + "." + std::to_string(getpid() + i) + ".part";
        fd = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, executable ? 0777 : 0666);
    }
    if (fd < 0) return false;
    const char *from = (const char *)bytes;
    int wrong = 0;
    while (size && !wrong) {
        ssize_t n = write(fd, from, size);
        if (n > 0) {
            from += n;
            size -= (size_t)n;
        } else
            wrong = n < 0 ? errno : ENOSPC;
    }
    if (close(fd) && !wrong) wrong = errno;
    if (!stays && !wrong && rename(part.c_str(), path.c_str())) wrong = errno;
    if (!stays && wrong) unlink(part.c_str());
    errno = wrong;
    return !wrong;
}

bool canWrite(const std::string &path) {
    struct stat s;
    if (stat(path.c_str(), &s) == 0 && !S_ISREG(s.st_mode)) {
        if (S_ISDIR(s.st_mode)) errno = EISDIR;
        return !S_ISDIR(s.st_mode) && !access(path.c_str(), W_OK);
    }
    size_t slash = path.rfind('/');
    std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    return !access(folder.c_str(), W_OK | X_OK);
}

long fileSize(const char *path) {
    struct stat s;
    return stat(path, &s) == 0 ? (long)s.st_size : -1;
}

} // namespace pack

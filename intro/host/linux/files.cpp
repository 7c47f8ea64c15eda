#include "host/files.h"

#include "host/linux/sys.h"

#include <sys/stat.h>

namespace odraz {

static const char *reason(long error) {
    switch (-error) {
    case sys::kEnoent:
        return "no such directory";
    case sys::kEbadf:
        return "it is closed";
    case sys::kEacces:
        return "permission denied";
    case sys::kEexist:
    case sys::kEnotdir:
        return "not a directory";
    case sys::kEisdir:
        return "it is a directory";
    case sys::kEnospc:
        return "no space left on the device";
    case sys::kErofs:
        return "the file system is read-only";
    case sys::kEpipe:
        return "the pipe was closed";
    case sys::kEnametoolong:
        return "the name is too long";
    case sys::kEfbig:
        return "the limit on a file's size is reached (ulimit -f)";
    default:
        return "the system refused";
    }
}

const char *writeAll(int descriptor, const void *data, size_t size) {
    const char *p = (const char *)data;
    while (size) {
        long n = sys::call(sys::kWrite, descriptor, (long)p, (long)size);
        if (n == -sys::kEintr) continue;
        if (n == -sys::kEagain) { // a non-blocking pipe is full
            sys::waitFor(descriptor, sys::kOutput, -1);
            continue;
        }
        if (n < 0) return reason(n);
        p += n;
        size -= (size_t)n;
    }
    return nullptr;
}

const char *writeFile(const char *path, const void *data, size_t size) {
    // Write directly to an existing pipe or device, which is neither a file nor a directory
    struct stat s;
    bool direct =
        sys::call(sys::kStat, (long)path, (long)&s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode);
    constexpr long kWriteNew = 0x80041 /* write, create, cloexec */, kOwn = 0x20080 /* exclusive, no links */;
    char part[4096];
    long fd = -sys::kEexist;
    if (direct) {
        fd = sys::call(sys::kOpen, (long)path, kWriteNew, 0666);
    } else {
        // Open an unused name: another process may be writing the same file, or somebody may have put a link
        // or a pipe there
        size_t length = 0;
        for (; path[length]; ++length) {
            if (length > sizeof part - 32) return "the name is too long";
            part[length] = path[length];
        }
        long id = sys::call(sys::kGetPid);
        for (long last = id + 100; id < last && fd == -sys::kEexist; ++id) {
            char *to = part + length;
            *to++ = '.';
            for (long rest = id; rest; rest /= 10) *to++ = (char)('0' + rest % 10);
            __builtin_memcpy(to, ".part", 6);
            fd = sys::call(sys::kOpen, (long)part, kWriteNew | kOwn, 0666);
        }
    }
    if (fd < 0) return reason(fd);
    const char *wrong = writeAll((int)fd, data, size);
    long closed = sys::call(sys::kClose, fd);
    if (!wrong && closed < 0) wrong = reason(closed);
    if (direct) return wrong;
    long renamed = wrong ? 0 : sys::call(sys::kRename, (long)part, (long)path);
    if (renamed < 0) wrong = reason(renamed);
    if (wrong) sys::call(sys::kUnlink, (long)part);
    return wrong;
}

const char *makeDirectory(const char *path) {
    long made = sys::call(sys::kMkdir, (long)path, 0777);
    if (made < 0 && made != -sys::kEexist) return reason(made);
    long fd = sys::call(sys::kOpen, (long)path, 0x90000 /* directory, cloexec */);
    if (fd < 0) return reason(fd);
    sys::call(sys::kClose, fd);
    return nullptr;
}

bool isTerminal(int descriptor) {
    char settings[64];
    return sys::call(sys::kIoctl, descriptor, 0x5401 /* TCGETS */, (long)settings) == 0;
}

long ownSize() {
    struct stat s;
    long fd = sys::call(sys::kOpen, (long)"/proc/self/exe", 0x80000);
    if (fd < 0) return 0;
    long got = sys::call(sys::kFstat, fd, (long)&s);
    sys::call(sys::kClose, fd);
    return got < 0 ? 0 : (long)s.st_size;
}

} // namespace odraz

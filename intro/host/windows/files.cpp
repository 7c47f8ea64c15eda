#include "host/files.h"

#include "base/text.h"
#include "host/windows/windows.h"

namespace odraz {

using namespace windows;

namespace {

constexpr int kLongest = 4096; // units of UTF-16 in a path, at most
constexpr uint32_t kWrite = 0x40000000, kShare = 7, kNew = 1, kExisting = 3, kDisk = 1 /* GetFileType */,
                   kDirectory = 16;

// Returns the reason of the last error. `size`: the path's size in units of UTF-16, including its zero; 0 if
// it did not fit, 1 if it does not matter.
const char *reason(int size = 1) {
    const char *tooLong = "the name is too long";
    switch (GetLastError()) {
    case kFileNotFound:
    case kPathNotFound:
        // Windows finds no path longer than 247 units, 259 for files
        return (unsigned)size - 1 > 247 ? tooLong : "no such directory";
    case kAccessDenied:
    case kSharing: // another program has it open
        return "permission denied";
    case kInvalidHandle:
        return "it is closed";
    case kWriteProtect:
        return "the file system is read-only";
    case kHandleDiskFull:
    case kDiskFull:
        return "no space left on the device";
    case kFileExists:
    case kAlreadyExists:
    case kNoDirectory:
        return "not a directory";
    case kBrokenPipe:
    case kNoData:
    case kNotConnected:
        return "the pipe was closed";
    case kNameTooLong:
        return tooLong;
    default:
        return "the system refused";
    }
}

// A path in UTF-16.
struct WidePath {
    WCHAR units[kLongest];
    int size; // including the zero; 0: it is too long
    WidePath(const char *path) {
        size = MultiByteToWideChar(kUtf8, 0, path, -1, units, kLongest);
        if (!size) *units = 0;
    }
};

const char *writeTo(HANDLE file, const void *data, size_t size) {
    const char *p = (const char *)data;
    while (size) {
        uint32_t n = size < 1 << 24 ? (uint32_t)size : 1 << 24;
        if (!WriteFile(file, p, n, &n, nullptr)) return reason();
        p += n;
        size -= n;
    }
    return nullptr;
}

bool isDirectory(const WidePath &path) {
    FileAttributes found;
    return GetFileAttributesExW(path.units, 0, &found) && found.attributes & kDirectory;
}

} // namespace

const char *writeAll(int descriptor, const void *data, size_t size) {
    return writeTo(standard(descriptor), data, size);
}

const char *writeFile(const char *path, const void *data, size_t size) {
    // Write directly to an existing pipe or device, which is neither a file nor a directory
    WidePath target(path);
    HANDLE file = CreateFileW(target.units, kWrite, kShare, nullptr, kExisting, 0, nullptr);
    bool direct = file != kInvalid && GetFileType(file) != kDisk;
    Text<kLongest> part;
    if (!direct) {
        CloseHandle(file);
        // Open an unused name: another process may be writing the same file
        uint32_t id = GetCurrentProcessId(), last = id + 100;
        do {
            part.size = 0;
            part << path << '.' << (int64_t)id << ".part";
            if (part.size >= kLongest - 1) return "the name is too long";
            file = CreateFileW(WidePath(part.data).units, kWrite, 0, nullptr, kNew, 0, nullptr);
        } while (file == kInvalid && GetLastError() == kFileExists && ++id < last);
        if (file == kInvalid) return reason(target.size);
    }
    const char *wrong = writeTo(file, data, size);
    if (!CloseHandle(file) && !wrong) wrong = reason();
    if (direct) return wrong;
    WidePath from(part.data);
    // Virus scanners may hold a new file open for a while
    for (int tries = 0; !wrong && !MoveFileExW(from.units, target.units, 1 /* replace */); Sleep(50)) {
        const char *why = reason();
        if (isDirectory(target))
            wrong = "it is a directory";
        else if (++tries == 20)
            wrong = why;
    }
    if (wrong) DeleteFileW(from.units);
    return wrong;
}

const char *makeDirectory(const char *path) {
    WidePath wide(path);
    if (CreateDirectoryW(wide.units, nullptr)) return nullptr;
    const char *wrong = reason(wide.size);
    return isDirectory(wide) ? nullptr : wrong;
}

bool isTerminal(int descriptor) {
    uint32_t mode;
    return GetConsoleMode(standard(descriptor), &mode);
}

long ownSize() {
    WCHAR name[kLongest];
    FileAttributes found;
    GetModuleFileNameW(nullptr, name, kLongest);
    return GetFileAttributesExW(name, 0, &found) ? found.sizeLow : 0;
}

} // namespace odraz

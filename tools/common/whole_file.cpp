#include "tools/common/whole_file.h"

#include "tools/common/command_line.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <sys/stat.h>
#include <unistd.h>

namespace common {

namespace fs = std::filesystem;

static constexpr long kMostBytes = 4l << 30;

static std::string cannot(const char *what, const std::string &path) {
    return std::string("cannot ") + what + " " + path + ": " + std::strerror(errno);
}

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

// Opens a regular file. A device or a pipe may never end, and opening a pipe may block forever.
static OpenFile openRegular(const std::string &path, struct stat &s) {
    if (stat(path.c_str(), &s) == 0 && !S_ISREG(s.st_mode))
        throw Refused("cannot read " + path + ": not a regular file");
    OpenFile file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file || fstat(fileno(file.get()), &s) != 0) throw Refused(cannot("read", path));
    std::setvbuf(file.get(), nullptr, _IONBF, 0);
    return file;
}

// Reads at most this number of bytes.
static std::string readFrom(std::FILE *file, const std::string &path, size_t size) {
    std::string bytes(size, '\0');
    bytes.resize(std::fread(bytes.data(), 1, size, file));
    if (std::ferror(file)) throw Refused(cannot("read", path));
    return bytes;
}

std::string readWhole(const std::string &path) {
    struct stat s;
    noteInput(path);
    OpenFile f = openRegular(path, s);
    if (s.st_size > kMostBytes) throw Refused("cannot read " + path + ": larger than 4 GB");
    return readFrom(f.get(), path, (size_t)s.st_size);
}

std::string readStart(const std::string &path, size_t size) {
    struct stat s;
    return readFrom(openRegular(path, s).get(), path, size);
}

std::string outputOf(const std::string &command, int *status) {
    std::FILE *printed = popen(command.c_str(), "r");
    if (!printed) throw std::runtime_error("cannot run " + command + ": " + std::strerror(errno));
    std::string output;
    char buffer[1 << 16];
    while (size_t size = std::fread(buffer, 1, sizeof buffer, printed)) output.append(buffer, size);
    const int ended = pclose(printed);
    if (status) *status = ended;
    return output;
}

// What a path names, after following symbolic links.
struct Target {
    std::string path;
    bool direct = false; // a device, a pipe or a descriptor, which is written to directly; else a file
    int descriptor = -1; // an open descriptor of this process (/dev/stdout, /dev/fd/3); it may have no path
};
static Target targetOf(const std::string &given) {
    std::error_code none;
    fs::path path = given;
    for (int i = 0; i < 40; ++i) {
        const std::string name = path.filename();
        if (name.find_first_not_of("0123456789") == name.npos &&
            fs::equivalent(path.parent_path(), "/proc/self/fd", none))
            return {given, true, std::atoi(name.c_str())};
        if (!fs::is_symlink(path, none)) break;
        path = path.parent_path() / fs::read_symlink(path, none);
    }
    struct stat s;
    if (stat(given.c_str(), &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode)) return {given, true};
    return {path};
}

void checkWritable(const std::string &given) {
    const auto [path, direct, descriptor] = targetOf(given);
    struct stat s;
    if (stat(path.c_str(), &s) == 0 && S_ISDIR(s.st_mode))
        throw Refused("cannot write " + path + ": is a folder");
    size_t slash = path.rfind('/');
    std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    const int flags = fcntl(descriptor, F_GETFL);
    errno = EBADF;
    if (descriptor < 0 ? access(direct ? path.c_str() : folder.c_str(), W_OK) != 0
                       : flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
        throw Refused(cannot("write", path));
}

// --- The files of a run ---

static constexpr char kReplaced[] = " would be overwritten: give another name";
static std::mutex theLock;
static int theStandardOutput = -1; // its copy if it is an output: stdout then prints to standard error
static std::map<std::string, std::string> theInputs, theOutputs; // names, keyed by identityOf()

// Returns device and inode of a regular file, or the path of a missing file. Empty for devices and pipes.
static std::string identityOf(const std::string &path) {
    struct stat s;
    if (stat(path.c_str(), &s) == 0)
        return S_ISREG(s.st_mode) ? std::to_string(s.st_dev) + ":" + std::to_string(s.st_ino) : "";
    std::error_code none;
    return fs::weakly_canonical(fs::absolute(targetOf(path).path, none), none);
}

void noteInput(const std::string &path) {
    std::lock_guard lock(theLock);
    const std::string id = identityOf(path);
    if (theOutputs.count(id)) throw WouldReplace(path + kReplaced);
    if (!id.empty()) theInputs.emplace(id, path);
}

bool claimOutput(const std::string &path, const std::string &replaces) {
    checkWritable(path);
    std::lock_guard lock(theLock);
    const std::string id = identityOf(path);
    const auto [ignored, direct, descriptor] = targetOf(path);
    if (descriptor == STDOUT_FILENO && theStandardOutput < 0) { // reserve it for the output
        std::fflush(stdout);
        theStandardOutput = dup(STDOUT_FILENO);
        dup2(STDERR_FILENO, STDOUT_FILENO);
    }
    if (id.empty() || (!replaces.empty() && id == identityOf(replaces))) return !direct;
    if (auto input = theInputs.find(id); input != theInputs.end()) throw Refused(input->second + kReplaced);
    need(theOutputs.emplace(id, path).second, path + " is used for two outputs: give another name");
    return !direct;
}

void forgetFiles() {
    std::lock_guard lock(theLock);
    theInputs.clear(), theOutputs.clear();
}

// Writes all bytes and closes the file. Returns 0 or an errno.
static int writeAndClose(int file, std::string_view bytes) {
    int wrong = 0;
    while (!bytes.empty() && !wrong) {
        ssize_t n = write(file, bytes.data(), bytes.size());
        if (n > 0)
            bytes.remove_prefix((size_t)n);
        else if (n == 0 || errno != EINTR)
            wrong = n < 0 ? errno : ENOSPC;
    }
    if (close(file) && !wrong) wrong = errno;
    return wrong;
}

void writeWhole(const std::string &given, std::string_view bytes, unsigned mode) {
    const auto [path, direct, descriptor] = targetOf(given);
    std::string part = path;
    int file = descriptor == STDOUT_FILENO && theStandardOutput >= 0 ? dup(theStandardOutput)
               : descriptor >= 0                                     ? dup(descriptor)
               : direct                                              ? open(path.c_str(), O_WRONLY)
                                                                     : -1;
    if (!direct) errno = EEXIST;
    for (int i = 0; i < 100 && file < 0 && errno == EEXIST; ++i) {
        part = path + "." + std::to_string(getpid() + i) + ".part";
        file = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, mode ? mode : 0666);
    }
    if (file < 0) throw std::runtime_error(cannot("write", path));
    if (!direct && mode) fchmod(file, mode); // ignores the umask
    int wrong = writeAndClose(file, bytes);
    if (!direct && !wrong && rename(part.c_str(), path.c_str())) wrong = errno;
    if (!direct && wrong) unlink(part.c_str());
    errno = wrong;
    if (wrong) throw std::runtime_error(cannot("write", path));
}

bool removeWhole(const std::string &given) {
    const auto [path, direct, descriptor] = targetOf(given);
    std::error_code none;
    return !direct && fs::is_regular_file(path, none) && fs::remove(path, none);
}

} // namespace common

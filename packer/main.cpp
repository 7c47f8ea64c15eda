// pack: makes a small self-unpacking executable out of a freestanding one.
#include "encoder.h"
#include "filter.h"
#include "program.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

constexpr char kUsage[] = "usage: pack IN.elf -o OUT [--budget BYTES=65536]";

int refuse(const std::string &line, int status) {
    std::fprintf(stderr, "pack: %s\n", line.c_str());
    return status;
}

bool readFile(const char *path, std::vector<uint8_t> &bytes) {
    std::FILE *f = std::fopen(path, "rb");
    if (!f) return false;
    uint8_t buffer[65536];
    while (size_t n = std::fread(buffer, 1, sizeof buffer, f)) bytes.insert(bytes.end(), buffer, buffer + n);
    bool good = !std::ferror(f);
    std::fclose(f);
    return good;
}

// Beside the target first, so that it is never half-written.
bool writeExecutable(const std::string &path, const std::vector<uint8_t> &bytes) {
    std::string part = path + ".part";
    int fd = open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0777);
    if (fd < 0) return false;
    size_t done = 0;
    while (done < bytes.size()) {
        ssize_t n = write(fd, bytes.data() + done, bytes.size() - done);
        if (n < 0) break;
        done += (size_t)n;
    }
    bool good = close(fd) == 0 && done == bytes.size() && rename(part.c_str(), path.c_str()) == 0;
    if (!good) unlink(part.c_str());
    return good;
}

long sizeOf(const char *path) {
    struct stat s;
    return stat(path, &s) == 0 ? (long)s.st_size : -1;
}

int run(const char *in, const char *out, long budget) {
    std::vector<uint8_t> file;
    if (!readFile(in, file)) return refuse(std::string("cannot read ") + in + ": " + std::strerror(errno), 2);
    pack::Program program = pack::readProgram(file);

    // Filter, encode, and prove that the stub's code gives the program back
    std::vector<uint8_t> filtered = program.bytes;
    uint32_t code = std::min<uint32_t>(program.codeSize, (uint32_t)filtered.size());
    pack::filterAddresses<true>(filtered.data(), code, program.span);
    std::vector<uint8_t> payload = pack::encode(filtered);
    std::vector<uint8_t> again = pack::decodeAgain(payload, filtered.size());
    pack::filterAddresses<false>(again.data(), code, program.span);
    if (again != program.bytes)
        return refuse("the packed bytes do not decode to the program; nothing was written", 3);

    std::vector<uint8_t> packed = pack::writePacked(program, payload);
    long size = (long)packed.size(), before = sizeOf(out);
    if (size > budget) return refuse("over budget by " + std::to_string(size - budget) + " bytes", 1);
    if (!writeExecutable(out, packed))
        return refuse(std::string("cannot write ") + out + ": " + std::strerror(errno), 2);
    std::printf("%s: %ld bytes (%zu of them stub and headers) from %zu", out, size, pack::overhead(),
                program.bytes.size());
    if (before >= 0) std::printf(", before %ld (%+ld)", before, size - before);
    std::printf(", %ld bytes left of %ld\n", budget - size, budget);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    const char *in = nullptr, *out = nullptr;
    long budget = 65536;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--help")) return std::printf("%s\n", kUsage), 0;
        if (!std::strcmp(argv[i], "-o") && i + 1 < argc && !out)
            out = argv[++i];
        else if (!std::strcmp(argv[i], "--budget") && i + 1 < argc) {
            char *end;
            budget = std::strtol(argv[++i], &end, 10);
            if (*end || end == argv[i] || budget < 0)
                return refuse(std::string("--budget needs a number of bytes, not '") + argv[i] + "'", 2);
        } else if (argv[i][0] != '-' && !in)
            in = argv[i];
        else
            return refuse(std::string("cannot use '") + argv[i] + "'; " + kUsage, 2);
    }
    if (!in || !out) return refuse(kUsage, 2);
    try {
        return run(in, out, budget);
    } catch (const pack::Unsuitable &e) {
        return refuse(std::string(in) + ": " + e.what(), 2);
    }
}

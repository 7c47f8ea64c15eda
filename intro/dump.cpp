#include "dump.h"

#include "host/files.h"
#include "host/process.h"

namespace odraz {

constexpr int kLongestName = 150; // told whole

int cannotWrite(const char *what, const char *why) {
    // Of a long name the end, so that the reason is told too
    int length = 0;
    while (what[length]) ++length;
    Message m;
    m << "cannot write ";
    if (length > kLongestName) m << "...", what += length - kLongestName;
    m << what << ": " << why;
    return complain(m.data);
}

int checkOutput(const char *to, bool stdoutClosed) {
    if (!isStdout(to)) return 0;
    if (stdoutClosed) return cannotWrite("standard output", "it is closed");
    if (!isTerminal(1)) return 0;
    complain("what goes to - is not text: send it to a program or a file, not to the terminal");
    return 2;
}

int writeOutput(const char *to, const void *data, size_t size) {
    bool toStdout = isStdout(to);
    const char *wrong = toStdout ? writeAll(1, data, size) : writeFile(to, data, size);
    return wrong ? cannotWrite(toStdout ? "standard output" : to, wrong) : 0;
}

int dump(Intro &intro, const Options &o, bool stdoutClosed) {
    if (int status = checkOutput(o.dump, stdoutClosed)) return status;
    bool toStdout = isStdout(o.dump);
    if (!toStdout)
        if (const char *wrong = makeDirectory(o.dump)) return cannotWrite(o.dump, wrong);
    const Quality &quality = o.qualityOr(QualityName::Film);
    // As it is played, frames of even numbers are traced, and the others made from the two beside them
    int64_t traced = -1;
    Picture later = {};
    auto trace = [&](int64_t n) {
        if (traced != n) later = picture(intro, frameTime(n, o.fps), quality);
        traced = n;
    };

    for (int64_t n = firstFrame(o.from, o.fps), end = firstFrame(o.to, o.fps); n < end; ++n) {
        bool between = o.live && n & 1;
        if (between) trace(n - 1);
        trace(n + between);
        Picture p = between ? pictureBetween(intro) : later;
        if (const char *limit = outgrown(intro))
            return cannotWrite("a scene that outgrew a limit; raise in scene.h", limit);
        // Pack it in place as a PPM: the header in front, three bytes of every four behind it
        Text<32> header;
        header << "P6\n" << p.width << ' ' << p.height << "\n255\n";
        size_t pixels = (size_t)p.width * (size_t)p.height;
        uint8_t *file = p.rgba - kHeaderRoom;
        for (int i = 0; i < header.size; ++i) file[i] = (uint8_t)header.data[i];
        uint8_t *to = file + header.size;
        for (size_t i = 0; i < pixels; ++i)
            for (size_t c = 0; c < 3; ++c) *to++ = p.rgba[4 * i + c];
        size_t size = (size_t)(to - file);

        Text<4200> path; // too long a name is told, never cut off
        path << o.dump;
        if (!toStdout) (path << "/frame-").number((uint64_t)n, 6) << ".ppm";
        if (int status = writeOutput(path.data, file, size)) return status;
    }
    return 0;
}

} // namespace odraz

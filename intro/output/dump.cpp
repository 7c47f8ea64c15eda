#include "output/dump.h"

#include "host/files.h"
#include "host/process.h"
#include "output/output.h"

namespace odraz {

int dump(Intro &intro, const Options &o, bool stdoutClosed) {
    if (int status = checkOutput(o.dump, stdoutClosed)) return status;
    bool toStdout = isStdout(o.dump);
    if (!toStdout)
        if (const char *wrong = makeDirectory(o.dump)) return cannotWrite(o.dump, wrong);
    const Quality &quality = o.qualityOr(QualityName::Film);
    // With --quality live, as when the film is played, even frames are traced, into the two slots in turn.
    // Odd frames are made from their two neighbours
    auto slotOf = [&](int64_t n) { return o.live ? (int)(n >> 1 & 1) : 0; };
    int64_t traced = -1;
    Picture later = {};
    auto trace = [&](int64_t n) {
        if (traced != n) later = picture(intro, slotOf(n), frameTime(n, o.fps), quality);
        traced = n;
    };

    int64_t first = firstFrame(o.from, o.fps), end = firstFrame(o.to, o.fps);
    for (int64_t n = first; n < end; ++n) {
        bool inBetween = o.live && n & 1;
        if (inBetween) trace(n - 1);
        trace(n + inBetween);
        Picture p = inBetween ? between(intro, slotOf(n - 1), slotOf(n + 1)) : later;
        if (const char *limit = exceededLimit(intro)) return printError(limit);
        // Turn it into a PPM in place: a header, then three bytes of every four
        Text<32> header;
        header << "P6\n" << p.width << ' ' << p.height << "\n255\n";
        size_t pixels = (size_t)p.width * (size_t)p.height;
        uint8_t *file = p.rgba - kHeaderRoom;
        for (int i = 0; i < header.size; ++i) file[i] = (uint8_t)header.data[i];
        uint8_t *to = file + header.size;
        for (size_t i = 0; i < pixels; ++i)
            for (size_t c = 0; c < 3; ++c) *to++ = p.rgba[4 * i + c];
        size_t size = (size_t)(to - file);

        Text<4200> path; // longer than any path, so that one that is too long is reported, not cut off
        path << o.dump;
        if (!toStdout) (path << "/frame-").number((uint64_t)n, 6) << ".ppm";
        if (int status = writeOutput(path.data, file, size)) return status;
    }
    if (!toStdout && isTerminal(1)) {
        Text<4300> line;
        line << o.dump << ": " << end - first << " frames\n";
        writeAll(1, line.data, (size_t)line.size);
    }
    return 0;
}

} // namespace odraz

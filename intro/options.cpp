#include "options.h"

#include "base/parallel.h"
#include "trace/picture/frame.h"

namespace odraz {

const char kHelp[] =
    "usage: odraz [--window] [--stats]                 watch the film; ESC leaves\n"
    "       odraz --dump DIR|- [--fps N]               write its frames as binary PPM, into DIR or to "
    "stdout\n"
    "\n"
    "  --window           play in a window, not on the full screen\n"
    "  --stats            print at the end how fast every scene was traced and shown\n"
    "  --dump DIR         write DIR/frame-NNNNNN.ppm; numbers count from the film's start\n"
    "  --dump -           write all frames to standard output:\n"
    "                     odraz --dump - | ffmpeg -f image2pipe -c:v ppm -r 25 -i - film.mp4\n"
    "  --fps N|N/M        frames a second of a dump, like 25, 23.976 or 30000/1001 (default 25)\n"
    "  --from S, --to S   play or dump only the seconds [S, S); a frame's time n/fps decides (default: all)\n"
    "  --size WxH         pixels to trace, 1x1 to 7680x4320 (default 1280x720)\n"
    "  --quality NAME     draft, play, film or reference (default: what keeps up; film for dumps)\n"
    "  --threads N        1 to 64 (default: as many as there are processors); pictures do not depend on it\n"
    "  --version, --help\n";

static_assert(kMaxWorkers == 64 && kMaxWidth == 7680 && kMaxHeight == 4320, "the help says so");

namespace {

bool same(const char *a, const char *b) {
    while (*a && *a == *b) ++a, ++b;
    return *a == *b;
}

// Digits up to a limit; false when there are none or too many.
bool readInteger(const char *&p, int64_t limit, int64_t &value) {
    const char *start = p;
    for (value = 0; *p >= '0' && *p <= '9'; ++p) {
        value = value * 10 + (*p - '0');
        if (value > limit) return false;
    }
    return p != start;
}

// Digits with at most `places` more after a point.
bool readDecimal(const char *&p, int64_t limit, int places, Decimal &d) {
    if (!readInteger(p, limit, d.value)) return false;
    d.scale = 1;
    if (*p != '.') return true;
    const char *start = ++p;
    for (; *p >= '0' && *p <= '9'; ++p) {
        if (p - start == places) return false;
        d.value = d.value * 10 + (*p - '0');
        d.scale *= 10;
    }
    return p != start;
}

bool readSeconds(const char *p, Decimal &d) { return readDecimal(p, 100000, 6, d) && !*p; }

bool readRate(const char *p, Rate &fps) {
    Decimal top, bottom = {1, 1};
    if (!readDecimal(p, 1000000, 3, top)) return false;
    if (*p == '/') {
        if (top.scale > 1 || !readInteger(++p, 1000000, bottom.value)) return false;
    }
    fps = {top.value, bottom.value * top.scale};
    return !*p && fps.numerator <= 10000000 && fps.numerator * 1000 >= fps.denominator &&
           fps.numerator <= fps.denominator * 1000 && fps.denominator > 0;
}

bool readSize(const char *p, Options &o) {
    int64_t w, h;
    if (!readInteger(p, kMaxWidth, w) || *p++ != 'x' || !readInteger(p, kMaxHeight, h) || *p || !w || !h)
        return false;
    o.width = (int)w;
    o.height = (int)h;
    return true;
}

bool readThreads(const char *p, Options &o) {
    int64_t n;
    if (!readInteger(p, kMaxWorkers, n) || *p || !n) return false;
    o.threads = (int)n;
    return true;
}

bool readQuality(const char *p, Options &o) {
    for (const Quality &q : kQualities)
        if (!q.internal && same(p, q.name)) o.quality = q.id;
    return o.quality != QualityName::Count;
}

// Reads the value of the option `name`, if there is such an option; otherwise leaves `right` null.
bool readValue(const char *name, const char *value, Options &o, const char *&right) {
    auto is = [&](const char *option, const char *form) {
        if (!same(name, option)) return false;
        right = form;
        return true;
    };
    if (is("--dump", "a directory, or - for standard output")) return (o.dump = value) && *value;
    if (is("--fps", "frames a second from 1/1000 to 1000, like 25 or 30000/1001"))
        return readRate(value, o.fps);
    if (is("--from", "seconds, like 12.5")) return readSeconds(value, o.from);
    if (is("--to", "seconds, like 12.5")) return readSeconds(value, o.to);
    if (is("--size", "WxH from 1x1 to 7680x4320, like 1280x720")) return readSize(value, o);
    if (is("--quality", "draft, play, film or reference")) return readQuality(value, o);
    if (is("--threads", "a number from 1 to 64")) return readThreads(value, o);
    return false;
}

} // namespace

bool parseOptions(int argc, const char *const *argv, double duration, Options &o, Message &wrong) {
    for (int i = 1; i < argc; ++i) {
        const char *name = argv[i];
        if (same(name, "--help"))
            o.help = true;
        else if (same(name, "--version"))
            o.version = true;
        else if (same(name, "--window"))
            o.window = true;
        else if (same(name, "--stats"))
            o.stats = true;
        else {
            const char *right = nullptr, *value = i + 1 < argc ? argv[i + 1] : "";
            bool good = readValue(name, value, o, right);
            if (!right) {
                wrong << "unknown option '" << name << "': odraz --help lists them";
                return false;
            }
            if (!good) {
                wrong << name << " needs " << right;
                if (*value) wrong << ", not '" << value << "'";
                return false;
            }
            ++i;
        }
    }
    if (o.to.scale == 0) o.to = {(int64_t)(duration * 1e6), 1000000};
    double from = seconds(o.from), to = seconds(o.to);
    if (to > duration) {
        (wrong << "--to is beyond the film's end at ").decimal(duration, 1) << " s";
        return false;
    }
    if (from > to) {
        (wrong << "--from must not be after ").decimal(to, 1) << " s, where the film or --to ends";
        return false;
    }
    if (o.dump && (o.window || o.stats)) {
        wrong << (o.window ? "--window" : "--stats") << " is for playing, not for --dump";
        return false;
    }
    return true;
}

int64_t firstFrame(Decimal time, Rate fps) {
    // Below 10^11 * 10^7 over 10^6 * 10^9: exact in 64 bits
    int64_t top = time.value * fps.numerator, bottom = time.scale * fps.denominator;
    return (top + bottom - 1) / bottom;
}

double frameTime(int64_t n, Rate fps) { return (double)(n * fps.denominator) / (double)fps.numerator; }

} // namespace odraz

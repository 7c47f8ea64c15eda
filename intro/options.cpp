#include "options.h"

#include "base/parallel.h"
#include "film.h"
#include "trace/picture/frame.h"

namespace odraz {

static_assert(kMaxWorkers == 64 && kMaxWidth == 7680 && kMaxHeight == 4320, "the help names these limits");

namespace {

// Returns what follows `start` in `text`, or "?" if the text does not start with it.
[[gnu::noinline]] const char *after(const char *start, const char *text) {
    while (*start && *start == *text) ++start, ++text;
    return *start ? "?" : text;
}

bool same(const char *a, const char *b) { return !*after(a, b); }

// Reads an integer from 0 up to a limit. Returns false if there are no digits or the number is larger.
bool readInteger(const char *&p, int64_t limit, int64_t &value) {
    const char *start = p;
    for (value = 0; *p >= '0' && *p <= '9'; ++p) {
        value = value * 10 + (*p - '0');
        if (value > limit) return false;
    }
    return p != start;
}

// Reads a decimal number with at most `places` digits after the point.
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
    return !*p && fps.denominator > 0 && fps.numerator * 1000 >= fps.denominator &&
           fps.numerator <= fps.denominator * 1000;
}

// Reads a number from 1 up to a limit.
bool readCount(const char *&p, int limit, int &count) {
    int64_t n;
    if (!readInteger(p, limit, n)) return false;
    count = (int)n;
    return count > 0;
}

bool readQuality(const char *p, Options &o) {
    // `live`, as when the film is played: traced frames have quality `play`
    o.live = same(p, "live");
    if (o.live) p = "play";
    for (const Quality &q : kQualities)
        if (same(p, q.name)) {
            o.quality = q.id;
            return true;
        }
    return false;
}

bool readHelp(const char *, Options &o) { return o.help = true; }

struct Option {
    char name[10];
    char value[7]; // its value's name in the help; "" if it has no value
    // What the value must be: printed if it is wrong, and at the start of the option's help
    const char *expects;
    const char *helpTail; // the rest of its help
    bool (*read)(const char *p, Options &o);
};

constexpr Option kOptions[] = {
    {"--window", "", "play in a window, not on the full screen", "",
     [](const char *, Options &o) { return o.window = true; }},
    {"--mute", "", "play without music", "", [](const char *, Options &o) { return o.mute = true; }},
    {"--stats", "", "print at the end how fast every scene was traced and shown", "",
     [](const char *, Options &o) { return o.stats = true; }},
    {"--dump", "DIR|-", "a directory, or - for standard output", "",
     [](const char *p, Options &o) { return *(o.dump = p) != 0; }},
    {"--wav", "FILE|-", "a file, or - for standard output", "; the music",
     [](const char *p, Options &o) { return *(o.wav = p) != 0; }},
    {"--fps", "N|N/M", "frames a second from 1/1000 to 1000, like 25, 23.976 or 30000/1001", " (default 25)",
     [](const char *p, Options &o) { return readRate(p, o.fps); }},
    {"--from", "S", "seconds, like 12.5", ": play or dump only from here to --to",
     [](const char *p, Options &o) { return readSeconds(p, o.from); }},
    {"--to", "S", "seconds, like 12.5", "", [](const char *p, Options &o) { return readSeconds(p, o.to); }},
    {"--size", "WxH", "pixels to trace, 1x1 to 7680x4320", " (default 1280x720; played: the window's)",
     [](const char *p, Options &o) {
         o.sized = true;
         return readCount(p, kMaxWidth, o.width) && *p++ == 'x' && readCount(p, kMaxHeight, o.height) && !*p;
     }},
    {"--quality", "NAME", "draft, play, film, reference or live",
     " (default: what keeps up; film for dumps);\n                     live: play, every other frame between "
     "two, for --fps 60",
     readQuality},
    {"--threads", "N", "1 to 64", " (default: the number of processors)",
     [](const char *p, Options &o) { return readCount(p, kMaxWorkers, o.threads) && !*p; }},
    {"--doctor", "", "list what this machine has and lacks", "",
     [](const char *, Options &o) { return o.doctor = true; }},
    {"--version", "", "", "", [](const char *, Options &o) { return o.version = true; }},
    {"-h", "", "", "", readHelp},
    {"--help", "", "", "", readHelp},
};

} // namespace

bool isStdout(const char *path) { return same(path, "-"); }

void writeHelp(AnyText &t) {
    t << "usage: " FILM_NAME " [--window] [--mute]       watch the film\n"
         "       " FILM_NAME " --dump DIR|- [--fps N]    write its frames as binary PPM\n"
         "keys: space pauses, arrows seek, L loops, M mutes, F: window, ESC leaves\n";
    for (const Option &o : kOptions) {
        int line = t.size;
        t << "  " << o.name;
        if (*o.value) t << ' ' << o.value;
        if (*o.expects) t.padTo(line + 19) << o.expects << o.helpTail;
        t << '\n';
    }
}

bool parseOptions(int argc, const char *const *argv, double duration, Options &o, AnyText &wrong) {
    for (int i = 1; i < argc; ++i) {
        const char *name = argv[i], *value;
        const Option *option = kOptions;
        while (*(value = after(option->name, name)) && (*value != '=' || !*option->value))
            if (++option == kOptions + sizeof kOptions / sizeof *kOptions) {
                wrong << "unknown option '" << name << "': " FILM_NAME " --help lists them";
                return false;
            }
        // The value follows = or is the next word
        if (*value)
            ++value;
        else if (*option->value && ++i < argc)
            value = argv[i];
        if (!option->read(value, o)) {
            wrong << option->name << " needs " << option->expects;
            if (*value) wrong << ", not '" << value << '\'';
            return false;
        }
    }
    if (o.to.scale == 0) o.to = {(int64_t)(duration * 1e6), 1000000};
    double from = seconds(o.from), to = seconds(o.to);
    if (to > duration)
        (wrong << "--to is beyond the film's end at ").decimal(duration, 1) << " s";
    else if (from > to)
        (wrong << "--from must be at most ").decimal(to, 1) << " s, the film's end or --to";
    else if ((o.dump || o.wav) && (o.window || o.mute || o.stats))
        wrong << (o.window ? "--window"
                  : o.mute ? "--mute"
                           : "--stats")
              << " is for playing, not for --dump or --wav";
    else if (o.live && (!o.dump || o.fps.numerator != 60 * o.fps.denominator))
        wrong << "--quality live is for --dump with --fps 60";
    else if (o.dump && o.wav && isStdout(o.dump) && isStdout(o.wav))
        wrong << "--dump and --wav cannot both be -: name a file";
    return wrong.size == 0;
}

int64_t firstFrame(Decimal time, Rate fps) {
    // Exact in 64 bits: `top` is at most 10^11 * 10^6, `bottom` 10^6 * 10^6
    int64_t top = time.value * fps.numerator, bottom = time.scale * fps.denominator;
    return (top + bottom - 1) / bottom;
}

double frameTime(int64_t n, Rate fps) { return (double)(n * fps.denominator) / (double)fps.numerator; }

} // namespace odraz

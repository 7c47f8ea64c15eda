// The command line of odraz.
#pragma once

#include "base/text.h"
#include "trace/quality.h"

namespace odraz {

// A number of seconds, exactly as written: value / scale. `scale` is a power of ten up to 10^6.
struct Decimal {
    int64_t value, scale;
};

inline double seconds(Decimal d) { return (double)d.value / (double)d.scale; }

// Frames a second: numerator / denominator, both positive and at most 10^6; 1/1000 .. 1000.
struct Rate {
    int64_t numerator, denominator;
};

struct Options {
    bool help = false, version = false, doctor = false, window = false, mute = false, stats = false;
    const char *dump = nullptr; // a directory, "-" for standard output, null to play
    const char *wav = nullptr;  // a file, "-" for standard output
    int width = 1280, height = 720;
    bool sized = false;                       // whether --size was given
    int threads = 0;                          // 0: one for each processor
    QualityName quality = QualityName::Count; // Count: not given
    bool live = false;                        // whether every other frame is made from its neighbours
    Decimal from = {0, 1}, to = {0, 0};       // scale 0: not given
    Rate fps = {25, 1};

    // Returns the quality that was given, or `otherwise` if none was.
    const Quality &qualityOr(QualityName otherwise) const {
        return kQualities[(int)(quality == QualityName::Count ? otherwise : quality)];
    }
};

// Returns whether an output is standard output: "-".
bool isStdout(const char *path);

using Message = Text<256>;

// Reads the arguments after the program's name. If they are wrong, returns false and sets `wrong` to a line
// that says what is wrong and what is expected. `duration`: seconds of the film.
bool parseOptions(int argc, const char *const *argv, double duration, Options &options, AnyText &wrong);

// Returns the number of the first frame at or after a time: the smallest n with n / fps >= time.
int64_t firstFrame(Decimal time, Rate fps);

// Returns the time of frame n, in seconds.
double frameTime(int64_t n, Rate fps);

// Writes the text of --help.
void writeHelp(AnyText &text);

} // namespace odraz

// The cost of making a picture of the film, in instructions. tools/measure/play/costs counts it at some
// moments, qualities and sizes; between them it is interpolated.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace odraz {
struct Shot;
}

namespace odraz::measure {

// Instructions of a whole picture: posing and relighting, tracing, glare and development. Threads share the
// `parallel` part. One thread does the `serial` part while the others wait.
struct PictureCost {
    double serial, parallel;
};

// The kind of a picture: traced, or made between two traced pictures of the same level.
struct PictureKind {
    double seconds; // in the film
    float level;    // quality: 0 film, 1 play, 2 draft
    double pixels;
    double gap; // sixtieths of a second between the two traced pictures; 0: it is traced
};

class PictureCosts {
public:
    // Parses the table that `costs` writes: "seconds,gap,level,width,height,serial,parallel", counts in
    // thousands. Each moment needs traced pictures and in-betweens, and level 1 in two sizes for each gap.
    // Throws Refused with the number of the wrong line.
    explicit PictureCosts(const std::string &csv);

    // Interpolates the cost. It is linear in time within a shot, and linear in the gap of in-betweens. Its
    // logarithm is linear in the level and in the logarithm of pixels. Outside the counted times, gaps and
    // levels it is constant. A level counted at one size grows as level 1 does. Throws Refused if the
    // shot has no counted moment.
    PictureCost of(const PictureKind &kind) const;

private:
    using Sizes = std::map<double, PictureCost>; // by pixels
    using Levels = std::map<float, Sizes>;
    struct CountedMoment {
        double seconds;
        const Shot *shot;
        std::map<double, Levels> gaps; // 0: traced pictures
    };
    static PictureCost at(const Levels &levels, const PictureKind &kind);
    static PictureCost at(const CountedMoment &moment, const PictureKind &kind);
    std::vector<CountedMoment> moments; // in order of time
};

// The path of the repository's table.
extern const char kCostsFile[];

} // namespace odraz::measure

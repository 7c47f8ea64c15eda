// What making and showing a picture of the film costs, in instructions: counted at some moments, qualities
// and sizes by tools/measure/seen/costs, and interpolated between them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace odraz {
struct Shot;
}

namespace odraz::measure {

// Instructions of a whole picture: posing and relighting, tracing, glare and development. `parallel` is what
// threads share; the rest is done by one of them while the others wait.
struct Cost {
    double serial, parallel;
};

// A picture of the film, by its time, its level of quality (0 film, 1 play, 2 draft) and its number of
// pixels. It is traced, or made between two of that level.
struct Pictured {
    double seconds;
    float level;
    double pixels;
    double gap; // 0: traced; else the sixtieths of a second from one of these two to the other
};

class Costs {
public:
    // Reads the table, as `costs` writes it: "seconds,gap,level,width,height,serial,parallel", counts in
    // thousands. Each moment needs traced pictures and in-betweens, and level 1 in two sizes for each gap.
    // Throws Refused, with the number of the line that is wrong.
    explicit Costs(const std::string &csv);

    // Linear in time within a shot and in the gap of in-betweens; constant outside the counted range.
    // The logarithm is linear in the level, constant outside the counted levels, and linear in the logarithm
    // of pixels. A level counted at one size grows as level 1 does. Throws Refused if no moment of this shot
    // was counted.
    Cost of(const Pictured &asked) const;

private:
    using Sizes = std::map<double, Cost>; // by pixels
    using Levels = std::map<float, Sizes>;
    struct Moment {
        double seconds;
        const Shot *shot;
        std::map<double, Levels> gaps; // 0: of traced pictures
    };
    static Cost at(const Levels &levels, const Pictured &asked);
    static Cost at(const Moment &moment, const Pictured &asked);
    std::vector<Moment> moments; // in order of time
};

// The repository's table.
extern const char kCostsFile[];

} // namespace odraz::measure

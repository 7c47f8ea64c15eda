// What making and showing a picture of the film costs, in instructions: counted at some moments, qualities
// and sizes by tools/measure/seen/costs, and interpolated between them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace odraz {

struct Shot;

// Instructions of a whole picture: posing and relighting, tracing, glare and development. `parallel` is what
// threads share; the rest is done by one of them while the others wait.
struct Cost {
    double serial, parallel;
};

// What is asked for: a picture of the film's time, of a level of quality (0 film, 1 play, 2 draft) and of so
// many pixels, traced or made half-way between two of that level.
struct Pictured {
    double seconds;
    float level;
    double pixels;
    bool between;
};

class Costs {
public:
    // Reads the table, as `costs` writes it: "seconds,kind,level,width,height,serial,parallel", counts in
    // thousands, where the kind is "picture" or "between". Each moment needs a picture and an in-between of
    // level 1, both in two sizes. Throws Refused, with the line's number if it is a line's fault.
    explicit Costs(const std::string &csv);

    // Linear in time within a shot, and level outside of its counted moments; logarithms are linear in level
    // between counted ones, level outside, and linear in the logarithm of pixels. A level counted at one size
    // grows as level 1 does. Throws Refused if no moment of this shot was counted.
    Cost of(const Pictured &asked) const;

private:
    using Sizes = std::map<double, Cost>; // by pixels
    using Levels = std::map<float, Sizes>;
    struct Moment {
        double seconds;
        const Shot *shot;
        Levels kinds[2]; // of pictures; of in-betweens
    };
    static Cost at(const Moment &moment, const Pictured &asked);
    std::vector<Moment> moments; // in order of time
};

// The table that the repository has.
extern const char kCostsFile[];

} // namespace odraz

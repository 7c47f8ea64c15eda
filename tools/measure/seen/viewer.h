// What is seen of the pictures that were shown: every sixtieth of a second, what stands on the screen (in the
// middle of it) is compared with the film's picture of that very moment. So pictures that come late or too
// seldom count, as well as coarse ones.
#pragma once

#include "tools/measure/detect/screening.h"
#include "tools/measure/seen/shown.h"

namespace odraz {

// Sums over the sixtieths of a second.
struct Seen {
    int sixtieths = 0;
    int fresh = 0; // of these, how many brought another picture than the one before
    double flip = 0;
    double linear = 0, srgb = 0; // squares, 0 .. 255^2, means of a picture

    void add(const Seen &more) {
        sixtieths += more.sixtieths, fresh += more.fresh;
        flip += more.flip, linear += more.linear, srgb += more.srgb;
    }
    double meanFlip() const { return flip / sixtieths; }
    double linearPsnr() const; // dB, at most kMostPsnr
    double srgbPsnr() const;
};
inline constexpr double kMostPsnr = 99; // of pictures that are the same

class Viewer {
public:
    // Looks at a screen of so many pixels, while the film plays from one second to another. Throws
    // std::runtime_error.
    Viewer(int width, int height, double from, double to);

    // Adds what is seen from one second to another, sixtieth by sixtieth. Throws Refused if nothing stands on
    // the screen at one of them, or if a picture has more pixels than the screen.
    void look(const std::vector<Shown> &list, double from, double to, Seen &seen);

private:
    Picture made(const std::vector<Shown> &list, int i);

    Workers workers;
    Theatre theatre;
};

} // namespace odraz

// Compares the picture on the screen in the middle of every sixtieth of a second with the film's picture of
// that moment. So late and missing pictures count as errors, as coarse ones do.
#pragma once

#include "tools/measure/bench/screening.h"
#include "tools/measure/play/shown.h"
#include "tools/picture/flip.h"

#include <algorithm>
#include <functional>
#include <map>

namespace odraz::measure {

// The errors of shown pictures, summed over sixtieths of a second.
struct SeenErrors {
    int sixtieths = 0;
    int fresh = 0; // sixtieths with a new picture
    int flips = 0; // sixtieths whose FLIP is in `flip`: every fifth one
    double flip = 0;
    double srgb = 0; // mean squared difference of each picture, 0 .. 255^2

    void add(const SeenErrors &more) {
        sixtieths += more.sixtieths, fresh += more.fresh, flips += more.flips;
        flip += more.flip, srgb += more.srgb;
    }
    double meanFlip() const { return flip / std::max(1, flips); }
    double srgbPsnr() const; // dB, at most kMostPsnr
};
inline constexpr double kMostPsnr = 99; // for equal pictures

class Viewer {
public:
    // Prepares a screen of width x height pixels for the film from one second to another. Throws
    // std::runtime_error.
    Viewer(int width, int height, double from, double to);

    // Adds the errors of each sixtieth from one second to another. Passes the picture on the screen and the
    // film's to `each`, in sRGB, 3 bytes a pixel. Throws Refused if the screen shows nothing at one of the
    // sixtieths, or if a picture has more pixels than the screen.
    using Each = std::function<void(const std::vector<uint8_t> &shown, const std::vector<uint8_t> &truth)>;
    void compare(const std::vector<ShownPicture> &list, double from, double to, SeenErrors &errors,
                 const Each &each = {});

private:
    Picture made(const std::vector<ShownPicture> &list, size_t i);
    Picture traced(int slot, const ShownPicture &shown);
    void keepTruth(long from, long to);

    Workers workers;
    MeasuredFilm film;
    // The last picture of each slot, so that it is not traced again
    struct TracedSlot {
        ShownPicture shown;
        Picture picture;
    } slots[kSlots] = {};
    // The film's pictures by sixtieths, kept because several lists are compared with them
    struct Truth {
        std::vector<uint8_t> rgb;
        pictures::SeenPicture perceived = {}; // empty until a FLIP needs it
    };
    std::map<long, Truth> truths;
    long mostTruths;
};

} // namespace odraz::measure

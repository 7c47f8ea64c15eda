// Compares the picture on the screen, in the middle of every sixtieth of a second, with the film's picture of
// that moment. So late and missing pictures lower the result, as well as coarse ones.
#pragma once

#include "tools/measure/detect/screening.h"
#include "tools/measure/seen/shown.h"
#include "tools/picture/flip.h"

#include <functional>
#include <map>

namespace odraz::measure {

// Sums over the sixtieths of a second.
struct Seen {
    int sixtieths = 0;
    int fresh = 0; // of these, those with a new picture
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
    // Looks at a screen of width x height pixels, while the film plays from one second to another. Throws
    // std::runtime_error.
    Viewer(int width, int height, double from, double to);

    // Adds what is seen from one second to another, sixtieth by sixtieth. Throws Refused if nothing is on the
    // screen at one of them, or if a picture has more pixels than the screen. The picture on the screen and
    // the truth are passed to `each`, in sRGB, 3 bytes a pixel.
    using Each = std::function<void(const std::vector<uint8_t> &shown, const std::vector<uint8_t> &truth)>;
    void look(const std::vector<Shown> &list, double from, double to, Seen &seen, const Each &each = {});

private:
    Picture made(const std::vector<Shown> &list, size_t i);
    Picture traced(int slot, const Shown &shown);
    void keepTruth(long from, long to);

    Workers workers;
    LoadedFilm film;
    // What the slots hold, which is not traced again
    struct Held {
        Shown shown;
        Picture picture;
    } held[kSlots] = {};
    // The film's pictures by sixtieths, kept because several lists are compared with the same ones
    struct Truth {
        std::vector<uint8_t> rgb;
        pictures::SeenPicture perceived;
    };
    std::map<long, Truth> truths;
    long mostTruths;
};

} // namespace odraz::measure

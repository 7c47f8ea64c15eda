// Hemicubes with any number of pixels along the top face. The film's have an even number; the thesis's
// smallest has 25.
//
// With an odd px a half face is px / 2 = h + 1/2 rows high. The picture is drawn as for an even px: the faces
// begin at rows px, px + h + 1/2, 2 px and 2 px + h + 1/2. Row px + h lies half on the first face's upper
// edge and half on the second one's horizon; its content is undefined and does not count; the rows next to it
// count for its halves. The same holds for row 2 px + h.
#pragma once

#include "radiosity/form_factor.h"
#include "tools/engine/heap_arena.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <functional>
#include <span>
#include <vector>

namespace odraz::radiosity {

// The running sums of the pixels' form factors along every row, for odd px too: px + 1 of each of 3 px rows.
std::vector<float> formFactorSums(int px);

// Hemicubes that OpenGL draws, 4 .. kMaxHemicube pixels along the top face, in memory of their own.
class AnyHemicubes {
public:
    // Throws std::runtime_error if OpenGL cannot draw them.
    AnyHemicubes(const Gl &gl, int px);
    AnyHemicubes(const AnyHemicubes &) = delete;
    ~AnyHemicubes() { closeHemicubes(h); }

    // Draws the hemicubes of up to h.batch eyes. Returns for each its form factors to every patch of the
    // model.
    const std::vector<std::vector<float>> &rows(const Model &model, std::span<const Eye> eyes,
                                                Workers &workers);

private:
    HeapArena memory;
    const std::vector<float> sums;
    std::vector<std::vector<float>> found;

public:
    Hemicubes h;
};

// The form factors of all patches; one that is not known is hidden, or nothing needs it.
struct FormFactorRows {
    std::vector<std::vector<Link>> of; // each patch
    std::vector<uint8_t> known;

    explicit FormFactorRows(size_t patches) : of(patches), known(patches) {}
    // The light that arrives at a patch from patches of these radiosities.
    Rgb gather(int patch, const std::vector<Rgb> &radiosity) const {
        Rgb sum = {};
        for (const Link &link : of[(size_t)patch]) sum += radiosity[link.patch] * link.share;
        return sum;
    }
};

// Finds the rows of the visible patches that `lit` marks; the others are left out of them. A patch has `each`
// hemicubes, which stand at `eyeOf` or, if that is null, in its middle, each turned differently; the mean
// counts. Patches are taken in an order that spreads the first ones over the model. Calls progress(done)
// after every picture, and stops if it returns false. Throws std::runtime_error if they need more memory.
bool findRows(AnyHemicubes &hemicubes, const Model &model, const std::vector<uint8_t> &lit, Workers &workers,
              FormFactorRows &rows, size_t memory, const std::function<bool(float done)> &progress,
              int each = 1, const EyeOf &eyeOf = {});

} // namespace odraz::radiosity

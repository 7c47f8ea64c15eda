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
    static size_t bytesFor(int px) { return hemicubeBytes(px + px % 2); }

    // Draws the hemicubes of up to h.batch eyes, h.turns of them for a patch. Returns for each such patch the
    // sum of its form factors to every patch of the model.
    const std::vector<std::vector<float>> &rows(const Model &model, std::span<const Eye> eyes,
                                                Workers &workers);

private:
    HeapArena memory;
    const std::vector<float> sums;
    std::vector<std::vector<float>> found;

public:
    Hemicubes h;
};

// The eye of a patch's hemicube number k.
using EyeOf = std::function<Eye(int patch, int k)>;

// As the film's findFormFactors(), for odd px too, and with hemicubes of patches at any place; without
// `eyeOf` they stand in the middle.
bool findRowsFrom(AnyHemicubes &hemicubes, const Model &model, const uint8_t *lit, Workers &workers,
                  Arena &arena, FormFactors &factors, const Progress &progress, int step,
                  const EyeOf &eyeOf = {});

} // namespace odraz::radiosity

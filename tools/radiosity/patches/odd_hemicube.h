// Hemicubes with any number of pixels along the top face. The film's have an even number; the thesis's
// smallest has 25.
//
// With an odd px a half face is px / 2 = h + 1/2 rows high. The picture is drawn as for an even px: the faces
// begin at rows px, px + h + 1/2, 2 px and 2 px + h + 1/2. Row px + h lies half on the first face's upper
// edge and half on the second one's horizon; its content is undefined and does not count; the rows next to it
// count for its halves. The same holds for row 2 px + h.
#pragma once

#include "radiosity/form_factor.h"

#include <functional>
#include <vector>

namespace odraz::radiosity {

// As openHemicubes() and hemicubeBytes(), for odd px too, 4 .. kMaxHemicube.
bool openAnyHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px);
size_t anyHemicubeBytes(int px);

// The running sums of the pixels' form factors along every row, for odd px too: px + 1 of each of 3 px rows.
std::vector<float> formFactorSums(int px);

// The eye of a patch's hemicube number k.
using EyeOf = std::function<Eye(int patch, int k)>;

// As the film's findFormFactors(), for odd px too, and with the h.turns hemicubes of each patch at any place;
// without `eyeOf` they stand in its middle.
bool findRowsFrom(Hemicubes &h, const Model &model, const uint8_t *lit, Workers &workers, Arena &arena,
                  FormFactors &factors, const Progress &progress, int step, const EyeOf &eyeOf = {});

} // namespace odraz::radiosity

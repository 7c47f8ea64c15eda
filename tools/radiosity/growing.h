// Light while it is being solved: what each texel has by now.
#pragma once

#include "tools/radiosity/bake.h"

namespace odraz {

// Direct light and, where radiosities of patches are given (Growing of bake.h), what comes of them by
// reflection. Called on the thread that solves.
std::vector<Rgb> lightSoFar(const Bake &bake, const float *radiosity);

} // namespace odraz

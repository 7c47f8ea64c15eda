// The options that say how a model is read, lit and solved: those of `solve`, which `view` of a model has,
// too.
#pragma once

#include "tools/common/arguments.h"
#include "tools/radiosity/bake.h"

#include <string>
#include <vector>

namespace odraz {

class SolveOptions {
public:
    // Whether it is one of them; then its value is taken. Throws Refused.
    bool take(const std::string &option, Arguments &words);
    // Reads what lights the model from outside, for which all options must be known. Throws Refused.
    void finish();

    ReadSettings read;
    BakeSettings settings;
    bool upIsZ = false;

private:
    std::string sky, byRays, byPatches; // the last option of either way
    std::vector<std::string> suns, lamps;
};

} // namespace odraz

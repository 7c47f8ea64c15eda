// The options that say how to read, light and solve a model, for `solve` and for `view` of a model.
#pragma once

#include "tools/common/arguments.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"

#include <string>
#include <vector>

namespace odraz {

class SolveOptions {
public:
    // Whether it is one of these options; if so, takes its value. Throws Refused.
    bool take(const std::string &option, Arguments &words);
    // Call it after the last option: reads the sky, suns and lamps. Throws Refused.
    void finish();

    ReadSettings read;
    SolveSettings settings;
    bool upIsZ = false;

private:
    std::string sky, byRays, byPatches; // the last option for each way
    std::vector<std::string> suns, lamps;
};

} // namespace odraz

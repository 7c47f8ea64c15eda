// The search for the contexts that compress a program best.
#pragma once

#include "packer/model/encoder.h"
#include "packer/model/estimate.h"

#include <functional>

namespace pack {

struct Progress {
    double bytes;   // the best payload so far, measured
    double seconds; // since the search began
    int tried;
};

// Changes one or two masks at a time and keeps what makes the estimate smaller (estimate.h), on all
// processors, until the time is over or `goOn` returns false. `goOn` is called after each try and at the end.
// The best result so far is measured now and then, and at the end. Returns the best parameters measured, or
// `start` if none are better. Two runs may give different results, so the result is kept in a file instead of
// being searched for again. With a program of 185 KB it needs 12 MB for each context, 50 MB for each
// processor, and the memory that decoding takes.
struct Searched {
    std::vector<Known> all;
    Layout layout;
    MayUse mayUse;
    std::function<double(const ModelParameters &, Workspace &, double enough)> measure;
};
ModelParameters search(const Searched &program, const ModelParameters &start, double seconds,
                       const std::function<bool(const Progress &)> &goOn);
template <class Around = Surroundings>
ModelParameters search(const std::vector<uint8_t> &filtered, const Layout &layout,
                       const ModelParameters &start, double seconds,
                       const std::function<bool(const Progress &)> &goOn) {
    auto measured = [&](const ModelParameters &parameters, Workspace &workspace, double enough) {
        return measure<Around>(filtered, layout, parameters, workspace, enough);
    };
    return search({knownOf<Around>(filtered, layout), layout, Around::mayUse, measured}, start, seconds,
                  goOn);
}

} // namespace pack

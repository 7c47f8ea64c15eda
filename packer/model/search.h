// The search for the contexts that compress a program best.
#pragma once

#include "packer/model/encoder.h"

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
ModelParameters search(const std::vector<uint8_t> &filtered, const Layout &layout,
                       const ModelParameters &start, double seconds,
                       const std::function<bool(const Progress &)> &goOn);

} // namespace pack

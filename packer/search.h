// The search for the contexts that suit a program best.
#pragma once

#include "encoder.h"

#include <functional>

namespace pack {

struct Progress {
    double bytes;   // the best payload so far, measured
    double seconds; // since the search began
    int tried;
};

// Changes a mask or two at a time and keeps what makes the estimate smaller (estimate.h), on all processors,
// until the time is over or `goOn`, called after each try and at the end, returns false. Now and then, and at
// the end, what has been found is measured. Returns the best that was measured, at worst `start`. Each time the
// outcome may be another: what is found is kept in a file, not found again. Needs 11 MB for each context and
// 35 MB for each processor with a program of 165 KB, and as much as decoding.
Shape search(const std::vector<uint8_t> &filtered, const Layout &layout, const Shape &start, double seconds,
             const std::function<bool(const Progress &)> &goOn);

} // namespace pack

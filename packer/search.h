// The search for the contexts that suit a program best.
#pragma once

#include "encoder.h"

#include <functional>

namespace pack {

struct Progress {
    double bytes;   // the best payload so far
    double seconds; // since the search began
    int tried;
};

// Changes one context at a time and keeps what makes the payload smaller, on all processors, until the time
// is over or `goOn`, called after each try, returns false. Returns the best, at worst `start`. Each time the
// outcome may be another: what is found is kept in a file, not found again.
Shape search(const std::vector<uint8_t> &filtered, const Layout &layout, const Shape &start, double seconds,
             const std::function<bool(const Progress &)> &goOn);

} // namespace pack

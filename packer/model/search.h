// The search for the contexts that compress a program best.
#pragma once

#include "packer/model/estimate.h"

#include <functional>

namespace pack {

struct Progress {
    double bytes;   // measured size of the best payload so far
    double seconds; // since the search began
    int tried;      // number of changes tried
};
using OnProgress = std::function<bool(const Progress &)>; // returns whether to continue

struct SearchInput {
    std::vector<ByteRecord> records;
    Layout layout;
    MayUse mayUse;
    std::function<double(const ModelParameters &)> measure; // returns the size of the payload
};

// Changes one or two masks at a time and keeps each change that makes the estimate smaller (estimate.h). Uses
// all processors, until the time is over or onProgress() returns false; onProgress() is called after each try
// and at the end. The best parameters are measured from time to time and at the end. Returns the best of
// the measured parameters, or `start` if none are better. Results differ from run to run. For 185 KB the
// search takes 12 MB for each context, 50 MB for each processor, and the memory of one decoder.
ModelParameters search(const SearchInput &program, const ModelParameters &start, double seconds,
                       const OnProgress &onProgress);
template <class Tracker = X86Tracker>
ModelParameters search(const Bytes &image, const Layout &layout, const ModelParameters &start, double seconds,
                       const OnProgress &onProgress) {
    auto measure = [&](const ModelParameters &p) { return encode<Tracker>(image, layout, p).size(); };
    auto records = byteRecords<Tracker>(filter<Tracker>(image, layout), layout);
    return search({std::move(records), layout, Tracker::mayUse, measure}, start, seconds, onProgress);
}

} // namespace pack

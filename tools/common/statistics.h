// Quantiles.
#pragma once

#include <algorithm>
#include <vector>

namespace common {

// Returns the value at the given share (0 .. 1) of the sorted values. `values` must not be empty.
template <class T> T quantile(std::vector<T> values, double share) {
    auto at = values.begin() + (long)((double)(values.size() - 1) * share);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

template <class T> T median(std::vector<T> values) { return quantile(std::move(values), 0.5); }

} // namespace common

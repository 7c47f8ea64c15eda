// Light at the texels of solutions, compared.
#pragma once

#include "base/vec3.h"

#include <gtest/gtest.h>
#include <vector>

namespace odraz {

// The largest difference of a channel, as a share of the brightest channel of b.
inline double apart(const std::vector<Rgb> &a, const std::vector<Rgb> &b) {
    EXPECT_EQ(a.size(), b.size());
    float most = 0, off = 0;
    for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
        Rgb d = a[i] - b[i];
        most = max(most, maxComponent(b[i]));
        off = max(off, max(maxComponent(d), maxComponent(-d)));
    }
    return (double)off / (double)most;
}

} // namespace odraz

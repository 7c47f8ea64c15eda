// Places of a model at which solutions are compared with a reference.
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

// Errors of luminance, in percent. rms: the root mean square of the differences as a share of that of the
// reference's light; median: of the relative differences at places that have at least a thousandth of the
// mean light.
struct LightErrors {
    double rms, median;
};

class Places {
public:
    // `count` places spread evenly by area over the charts that reflect, with the light that arrives there in
    // the reference.
    Places(const Solution &reference, int count);
    // The errors of another solution of the same model.
    LightErrors errorsOf(const Solution &solution) const;

private:
    struct Place {
        int chart;
        Vec3 p;
        float light; // luminance
    };
    std::vector<Place> places;
};

// The errors of values, one for each place, against those of the reference.
LightErrors errorsOf(const std::vector<float> &values, const std::vector<float> &reference);

} // namespace odraz::radiosity

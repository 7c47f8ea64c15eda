#include "tools/radiosity/study/places.h"

#include "base/random.h"
#include "tools/common/statistics.h"
#include "tools/engine/luminance.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

Places::Places(const Solution &reference, int count) {
    // All triangles of charts that reflect, with running sums of their area
    struct Part {
        int chart;
        Vec3 corner, u, v;
    };
    std::vector<Part> parts;
    std::vector<double> until;
    double area = 0;
    reference.forPieces([&](int chart, int, const std::vector<SolutionPoint> &piece) {
        if (maxComponent(reference.reflects[(size_t)chart]) <= 0) return;
        for (size_t i = 2; i < piece.size(); ++i) {
            Vec3 u = piece[i - 1].p - piece[0].p, v = piece[i].p - piece[0].p;
            parts.push_back({chart, piece[0].p, u, v});
            until.push_back(area += (double)length(cross(u, v)) / 2);
        }
    });
    for (int i = 0; i < count && area > 0; ++i) {
        float at = unitFloat(pcg((uint32_t)(3 * i))), a = unitFloat(pcg((uint32_t)(3 * i + 1))),
              b = unitFloat(pcg((uint32_t)(3 * i + 2)));
        auto k =
            std::upper_bound(until.begin(), until.end(), (i + (double)at) / count * area) - until.begin();
        const Part &part = parts[std::min((size_t)k, parts.size() - 1)];
        if (a + b > 1) a = 1 - a, b = 1 - b;
        Vec3 p = part.corner + part.u * a + part.v * b;
        places.push_back({part.chart, p, luminance(reference.lightAt(part.chart, p))});
    }
}

LightErrors Places::errorsOf(const Solution &solution) const {
    std::vector<float> values, reference;
    for (const Place &p : places) {
        values.push_back(luminance(solution.lightAt(p.chart, p.p)));
        reference.push_back(p.light);
    }
    return radiosity::errorsOf(values, reference);
}

LightErrors errorsOf(const std::vector<float> &values, const std::vector<float> &reference) {
    if (values.empty()) return {NAN, NAN};
    std::vector<double> relative;
    double error = 0, all = 0, sum = 0;
    for (float b : reference) sum += (double)b;
    const double dark = 1e-3 * sum / (double)reference.size();
    for (size_t i = 0; i < values.size(); ++i) {
        double a = (double)values[i], b = (double)reference[i];
        error += (a - b) * (a - b), all += b * b;
        if (b > dark) relative.push_back(std::fabs(a - b) / b);
    }
    if (all == 0 || relative.empty()) return {error == 0 ? 0 : NAN, error == 0 ? 0 : NAN};
    return {100 * std::sqrt(error / all), 100 * common::median(std::move(relative))};
}

} // namespace odraz::radiosity

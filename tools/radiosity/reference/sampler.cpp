#include "tools/radiosity/reference/sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace odraz::radiosity {

namespace {

double unit(uint64_t bits) { return (double)(bits >> 11) * 0x1p-53; }

// The step of each number from sample to sample: powers of the generalised golden ratio.
std::array<double, Sampler::kEven> evenSteps() {
    double root = 2;
    for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1. / (Sampler::kEven + 1));
    std::array<double, Sampler::kEven> steps;
    for (size_t i = 0; i < steps.size(); ++i) steps[i] = std::pow(1 / root, (double)i + 1);
    return steps;
}
const std::array<double, Sampler::kEven> kEvenSteps = evenSteps();

// The direction at an angle in the plane perpendicular to a normal
Vec3d across(Vec3d n, double angle) {
    Vec3d u = normalize(cross(n, std::fabs(n.x) > 0.5 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    return u * std::cos(angle) + cross(n, u) * std::sin(angle);
}

} // namespace

uint64_t mixed(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

Sampler::Sampler(uint64_t stream, uint64_t sample)
    : state(mixed(mixed(stream) ^ sample)), sample(sample), shift(mixed(stream)) {}

double Sampler::random() {
    state = mixed(state);
    return unit(state);
}

double Sampler::even(size_t k) const {
    double v = unit(mixed(shift + k)) + (double)(sample + 1) * kEvenSteps[k];
    return v - std::floor(v);
}

SquarePoint inCell(Sampler &sampler, int k, int side) {
    double a = sampler.random(), b = sampler.random();
    return {(k % side + a) / side, (k / side + b) / side};
}

Vec3d onTriangle(const std::array<Vec3d, 3> &c, SquarePoint at) {
    if (at.a + at.b > 1) at = {1 - at.a, 1 - at.b};
    return c[0] + (c[1] - c[0]) * at.a + (c[2] - c[0]) * at.b;
}

Vec3d byCosine(Vec3d n, SquarePoint at) {
    return n * std::sqrt(1 - at.a) + across(n, 2 * std::numbers::pi * at.b) * std::sqrt(at.a);
}

Vec3d inCone(Vec3d axis, double cosine, SquarePoint at) {
    double c = 1 - at.a * (1 - cosine), s = std::sqrt(std::max(1 - c * c, 0.));
    return axis * c + across(axis, 2 * std::numbers::pi * at.b) * s;
}

double coneOfBall(double distance, double radius) {
    double sine = std::min(radius / distance, 1.);
    return std::sqrt(1 - sine * sine);
}

} // namespace odraz::radiosity

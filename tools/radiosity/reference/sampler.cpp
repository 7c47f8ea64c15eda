#include "tools/radiosity/reference/sampler.h"

#include <cmath>
#include <numbers>

namespace odraz::radiosity {

// splitmix64 (Steele, Lea and Flood, 2014): a hash of 64 bits.
static uint64_t mixed(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

Sampler::Sampler(uint64_t stream) : state(mixed(mixed(stream))) {}

double Sampler::random() {
    state = mixed(state);
    return (double)(state >> 11) * 0x1p-53;
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
    Vec3d u = normalize(cross(n, std::fabs(n.x) > 0.5 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    double angle = 2 * std::numbers::pi * at.b;
    Vec3d across = u * std::cos(angle) + cross(n, u) * std::sin(angle);
    return n * std::sqrt(1 - at.a) + across * std::sqrt(at.a);
}

} // namespace odraz::radiosity

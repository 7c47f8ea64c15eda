#include "tools/picture/flip.h"

#include "tools/picture/psnr.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pictures {

namespace {

using Plane = std::vector<float>;
using Kernel = std::vector<float>; // odd size, centred

constexpr double kPixelsPerDegree = 3840 * M_PI / 180;
// Linear sRGB to XYZ, relative to white (D65), and back; rows sum to 1
struct Matrix {
    float m[3][3];
    std::array<float, 3> operator()(float x, float y, float z) const {
        return {m[0][0] * x + m[0][1] * y + m[0][2] * z, m[1][0] * x + m[1][1] * y + m[1][2] * z,
                m[2][0] * x + m[2][1] * y + m[2][2] * z};
    }
};
constexpr float kWhite[3] = {0.950428545f, 1, 1.088900371f};
constexpr Matrix kToXyz = {
    {{10135552 / 24577794.f / kWhite[0], 8788810 / 24577794.f / kWhite[0], 4435075 / 24577794.f / kWhite[0]},
     {2613072 / 12288897.f, 8788810 / 12288897.f, 887015 / 12288897.f},
     {1425312 / 73733382.f / kWhite[2], 8788810 / 73733382.f / kWhite[2],
      70074185 / 73733382.f / kWhite[2]}}};
constexpr Matrix kFromXyz = {{{3.241003275f * kWhite[0], -1.537398934f, -0.498615861f * kWhite[2]},
                              {-0.969224334f * kWhite[0], 1.875930071f, 0.041554224f * kWhite[2]},
                              {0.055639423f * kWhite[0], -0.204011202f, 1.057148933f * kWhite[2]}}};

struct LabColour {
    float l, a, b;
};

// Converts linear sRGB to CIELAB whose chroma falls with lightness (Hunt's effect)
LabColour perceived(float r, float g, float b) {
    auto f = [](float t) {
        constexpr float kKnee = 6 / 29.f;
        return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4 / 29.f;
    };
    auto [x, y, z] = kToXyz(r, g, b);
    float l = 116 * f(y) - 16, hunt = 0.01f * l;
    return {l, hunt * 500 * (f(x) - f(y)), hunt * 200 * (f(y) - f(z))};
}

float distance(const LabColour &p, const LabColour &q) { // HyAB
    return std::fabs(p.l - q.l) + std::sqrt((p.a - q.a) * (p.a - q.a) + (p.b - q.b) * (p.b - q.b));
}

// Samples f(x) from -radius to radius
template <class F> Kernel kernel(int radius, F &&f) {
    Kernel k;
    for (int x = -radius; x <= radius; ++x) k.push_back((float)f(x));
    return k;
}

// Scales positive weights to a sum of 1, and negative weights to a sum of -1
Kernel normalised(Kernel k) {
    float up = 0, down = 0;
    for (float w : k) (w > 0 ? up : down) += std::fabs(w);
    for (float &w : k) w /= w > 0 ? up : down;
    return k;
}

// Filters with the product of two kernels. Border pixels are repeated outside the picture.
Plane filtered(const Plane &in, int width, int height, const Kernel &across, const Kernel &down) {
    int rx = (int)across.size() / 2, ry = (int)down.size() / 2;
    Plane rows(in.size()), out(in.size()), padded((size_t)(width + 2 * rx));
    for (int y = 0; y < height; ++y) {
        const float *row = in.data() + (size_t)y * (size_t)width;
        for (int x = -rx; x < width + rx; ++x) padded[(size_t)(x + rx)] = row[std::clamp(x, 0, width - 1)];
        float *to = rows.data() + (size_t)y * (size_t)width;
        for (size_t k = 0; k < across.size(); ++k)
            for (size_t x = 0; x < (size_t)width; ++x) to[x] += across[k] * padded[x + k];
    }
    for (int y = 0; y < height; ++y) {
        float *to = out.data() + (size_t)y * (size_t)width;
        for (int k = -ry; k <= ry; ++k) {
            const float *from = rows.data() + (size_t)std::clamp(y + k, 0, height - 1) * (size_t)width;
            for (int x = 0; x < width; ++x) to[x] += down[(size_t)(k + ry)] * from[x];
        }
    }
    return out;
}

// How the eye blurs a channel: the Fourier transform of its contrast sensitivity, a sum of two Gaussians
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic = {1, 0.0047, 0, 1e-5}, kRedGreen = {1, 0.0053, 0, 1e-5},
                      kBlueYellow = {34.1, 0.04, 13.5, 0.025};

Plane blurred(const Plane &in, int width, int height, const Sensitivity &s) {
    int radius = (int)std::ceil(3 * std::sqrt(kBlueYellow.b1 / (2 * M_PI * M_PI)) * kPixelsPerDegree);
    double weight[2], all = 0; // integrals of the Gaussians over the plane, and their sum
    Kernel kernels[2];
    for (int i = 0; i < 2; ++i) {
        double b = i ? s.b2 : s.b1, sum = 0;
        auto gauss = [&](double x) {
            x /= kPixelsPerDegree;
            return std::exp(-M_PI * M_PI * x * x / b);
        };
        for (int x = -radius; x <= radius; ++x) sum += gauss(x);
        kernels[i] = normalised(kernel(radius, gauss));
        all += weight[i] = (i ? s.a2 : s.a1) * std::sqrt(M_PI / b) * sum * sum;
    }
    Plane out(in.size());
    for (int i = 0; i < 2; ++i) {
        if (weight[i] == 0) continue;
        Plane part = filtered(in, width, height, kernels[i], kernels[i]);
        for (size_t p = 0; p < out.size(); ++p) out[p] += (float)(weight[i] / all) * part[p];
    }
    return out;
}

// Feature strength: the length of the vector of a derivative filter's responses across and down
Plane strength(const Plane &in, int width, int height, const Kernel &derivative, const Kernel &gauss) {
    Plane across = filtered(in, width, height, derivative, gauss),
          down = filtered(in, width, height, gauss, derivative);
    for (size_t p = 0; p < across.size(); ++p)
        across[p] = std::sqrt(across[p] * across[p] + down[p] * down[p]);
    return across;
}

} // namespace

SeenPicture see(const std::vector<uint8_t> &rgb, int width, int height) {
    size_t pixels = (size_t)width * (size_t)height;
    SeenPicture seen = {width, height, Plane(pixels), Plane(pixels), Plane(pixels), {}, {}};

    // Convert to opponent colours
    Plane luminance(pixels), redGreen(pixels), blueYellow(pixels);
    for (size_t p = 0; p < pixels; ++p) {
        auto [x, y, z] = kToXyz((float)linearOfSrgb(rgb[3 * p]), (float)linearOfSrgb(rgb[3 * p + 1]),
                                (float)linearOfSrgb(rgb[3 * p + 2]));
        luminance[p] = y;
        redGreen[p] = x - y;
        blueYellow[p] = y - z;
    }

    // Detect edges and points of the luminance by the first and second derivatives of a Gaussian
    double sd = 0.5 * 0.082 * kPixelsPerDegree;
    int radius = (int)std::ceil(3 * sd);
    auto gauss = [&](double x) { return std::exp(-x * x / (2 * sd * sd)); };
    Kernel smooth = normalised(kernel(radius, gauss));
    Kernel edge = normalised(kernel(radius, [&](double x) { return x * gauss(x); }));
    Kernel point = normalised(kernel(radius, [&](double x) { return (x * x / (sd * sd) - 1) * gauss(x); }));
    seen.edges = strength(luminance, width, height, edge, smooth);
    seen.points = strength(luminance, width, height, point, smooth);

    // Filter by contrast sensitivity, clamp to the colours of a screen, convert to perceived colours
    luminance = blurred(luminance, width, height, kAchromatic);
    redGreen = blurred(redGreen, width, height, kRedGreen);
    blueYellow = blurred(blueYellow, width, height, kBlueYellow);
    for (size_t p = 0; p < pixels; ++p) {
        auto [r, g, b] = kFromXyz(luminance[p] + redGreen[p], luminance[p], luminance[p] - blueYellow[p]);
        LabColour c = perceived(std::clamp(r, 0.f, 1.f), std::clamp(g, 0.f, 1.f), std::clamp(b, 0.f, 1.f));
        seen.lightness[p] = c.l;
        seen.a[p] = c.a;
        seen.b[p] = c.b;
    }
    return seen;
}

std::vector<float> flip(const SeenPicture &reference, const SeenPicture &test) {
    // `most`: the distance of green and blue, the largest. Distances up to `knee` take 95 % of the range
    const float most = std::pow(distance(perceived(0, 1, 0), perceived(0, 0, 1)), 0.7f), knee = 0.4f * most;
    std::vector<float> error(reference.lightness.size());
    for (size_t p = 0; p < error.size(); ++p) {
        float colourDistance = distance({reference.lightness[p], reference.a[p], reference.b[p]},
                                        {test.lightness[p], test.a[p], test.b[p]});
        if (colourDistance == 0) continue;
        float e = std::pow(colourDistance, 0.7f);
        float colour = e < knee ? 0.95f * e / knee : 0.95f + 0.05f * (e - knee) / (most - knee);
        float feature = std::max(std::fabs(reference.edges[p] - test.edges[p]),
                                 std::fabs(reference.points[p] - test.points[p]));
        error[p] = std::pow(colour, 1 - std::sqrt(feature * (float)M_SQRT1_2));
    }
    return error;
}

double meanFlip(const SeenPicture &reference, const SeenPicture &test) {
    double sum = 0;
    for (float e : flip(reference, test)) sum += e;
    return sum / (double)reference.lightness.size();
}

} // namespace pictures

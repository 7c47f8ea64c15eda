#include "tools/radiosity/read/reflectance_picture.h"

#include "tools/support/clip.h"

#include <algorithm>
#include <cmath>

#include <stb/stb_image_resize.h>

namespace odraz::radiosity {

namespace {

using Polygon = std::vector<TexturePoint>;
constexpr double kMostTexels = 16; // along a side of the polygon

double areaOf(const Polygon &p) {
    double twice = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const TexturePoint &a = p[i], &b = p[(i + 1) % p.size()];
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return twice / 2;
}

// The part of a polygon whose coordinate along `axis` is above `at`, or below it if `sign` is -1.
Polygon cut(const Polygon &in, size_t axis, double at, double sign) {
    return clip(
        in, [&](const TexturePoint &p) { return (p[axis] - at) * sign; },
        [](const TexturePoint &p, const TexturePoint &q, double t) {
            return TexturePoint{p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t};
        });
}

} // namespace

ReflectancePicture::ReflectancePicture(const pictures::Picture &picture) {
    levels.push_back({picture.width, picture.height, {}});
    levels[0].texels.resize(picture.pixels());
    for (size_t i = 0; i < picture.pixels(); ++i) {
        auto linear = picture.linear(i);
        for (size_t k = 0; k < 3; ++k)
            levels[0].texels[i][k] = (uint16_t)(std::clamp(linear[k], 0.f, 1.f) * 65535 + 0.5f);
    }
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
}

// A texel of the smaller picture covers two by two texels; along an odd side, parts of three.
ReflectancePicture::Level ReflectancePicture::halved(const Level &of) {
    Level to = {(of.width + 1) / 2, (of.height + 1) / 2, {}};
    to.texels.resize((size_t)to.width * (size_t)to.height);
    stbir_resize_uint16_generic(of.texels[0].data(), of.width, of.height, 0, to.texels[0].data(), to.width,
                                to.height, 0, 3, STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP,
                                STBIR_FILTER_BOX, STBIR_COLORSPACE_LINEAR, nullptr);
    return to;
}

Rgb ReflectancePicture::texel(const Level &l, int64_t i, int64_t j, bool clamp) {
    auto within = [&](int64_t at, int64_t count) {
        return clamp ? std::clamp<int64_t>(at, 0, count - 1) : (at % count + count) % count;
    };
    const auto &c = l.texels[(size_t)(within(j, l.height) * l.width + within(i, l.width))];
    return Rgb{(float)c[0], (float)c[1], (float)c[2]} * (1 / 65535.f);
}

Rgb ReflectancePicture::mean() const { return texel(levels.back(), 0, 0, true); }

Rgb ReflectancePicture::mean(const Polygon &given, bool clamp) const {
    // Find the finest level in which the polygon covers at most kMostTexels along each side
    Polygon polygon = given;
    double lo[2] = {1e300, 1e300}, hi[2] = {-1e300, -1e300};
    for (TexturePoint &p : polygon) {
        if (!(std::fabs(p[0]) < 1e9 && std::fabs(p[1]) < 1e9)) return mean(); // not a number, or too large
        p[1] = 1 - p[1];
        for (size_t k = 0; k < 2; ++k) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
    }
    size_t level = 0;
    while (level + 1 < levels.size() && ((hi[0] - lo[0]) * levels[level].width > kMostTexels ||
                                         (hi[1] - lo[1]) * levels[level].height > kMostTexels))
        ++level;
    const Level &l = levels[level];
    // If it covers many repetitions of the picture, use the mean of the picture
    if ((hi[0] - lo[0]) * l.width > 4 * kMostTexels || (hi[1] - lo[1]) * l.height > 4 * kMostTexels)
        return mean();
    // Convert the polygon to texels, and average those inside it
    double middle[2] = {};
    for (TexturePoint &p : polygon) {
        p[0] *= l.width, p[1] *= l.height;
        for (size_t k = 0; k < 2; ++k) middle[k] += p[k] / (double)polygon.size();
    }
    if (areaOf(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
    double sum[3] = {}, all = 0;
    for (int64_t j = (int64_t)std::floor(lo[1] * l.height); (double)j < hi[1] * l.height; ++j) {
        const Polygon row = cut(cut(polygon, 1, (double)j, 1), 1, (double)j + 1, -1);
        if (row.size() < 3) continue;
        double left = 1e300, right = -1e300;
        for (const TexturePoint &p : row) left = std::min(left, p[0]), right = std::max(right, p[0]);
        for (int64_t i = (int64_t)std::floor(left); (double)i < right; ++i) {
            double area = areaOf(cut(cut(row, 0, (double)i, 1), 0, (double)i + 1, -1));
            if (!(area > 0)) continue;
            Rgb c = texel(l, i, j, clamp);
            sum[0] += area * (double)c.x, sum[1] += area * (double)c.y, sum[2] += area * (double)c.z;
            all += area;
        }
    }
    if (!(all > 1e-12))
        return texel(l, (int64_t)std::floor(middle[0]), (int64_t)std::floor(middle[1]), clamp);
    return {(float)(sum[0] / all), (float)(sum[1] / all), (float)(sum[2] / all)};
}

} // namespace odraz::radiosity

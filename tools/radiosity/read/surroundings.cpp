#include "tools/radiosity/read/surroundings.h"

#include "base/maths.h"
#include "tools/common/text.h"
#include "tools/picture/picture_file.h"
#include "tools/radiosity/read/upright.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <stb/stb_image_resize.h>

namespace odraz::radiosity {

namespace {

// Size of the picture that rays sample: a pixel is about as wide as a ray's share of the directions
constexpr int kSkyWidth = 128, kSkyHeight = 64;
constexpr double kTooBright = 8; // times the mean
constexpr size_t kMostSuns = 24;

double totalOf(const Rgb &c) { return (double)c.x + (double)c.y + (double)c.z; }

struct Glint { // the part of a pixel's light above the limit
    Vec3d towards;
    Rgb light; // radiance times solid angle over pi
};

// Makes at most `parts` suns from glints: divides them repeatedly, across their largest extent, into two
// groups with equal light.
void cut(std::vector<Glint>::iterator first, std::vector<Glint>::iterator end, size_t parts, bool upIsZ,
         std::vector<Sun> &suns) {
    Vec3d lo = first->towards, hi = lo, sum = {};
    Rgb light = {};
    for (auto g = first; g != end; ++g) {
        for (size_t k = 0; k < 3; ++k)
            lo[k] = std::min(lo[k], g->towards[k]), hi[k] = std::max(hi[k], g->towards[k]);
        sum = sum + g->towards * totalOf(g->light);
        light = light + g->light;
    }
    const Vec3d size = hi - lo;
    const size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (parts > 1 && size[axis] > 0.02) { // about a degree; smaller groups become one sun
        std::sort(first, end,
                  [&](const Glint &a, const Glint &b) { return a.towards[axis] < b.towards[axis]; });
        auto middle = first;
        double before = 0;
        while (middle != end - 1 && (before += totalOf(middle->light)) < totalOf(light) / 2) ++middle;
        middle = std::max(middle, first + 1);
        cut(first, middle, parts / 2, upIsZ, suns);
        cut(middle, end, parts - parts / 2, upIsZ, suns);
    } else if (length(sum) > 0)
        suns.push_back({asInModel(toFloat(normalize(sum)), upIsZ), light});
}

} // namespace

Rgb SkyPicture::radiance(const Vec3 &d) const {
    if (!width) return {};
    if (width == 1) return pixels[0];
    Vec3 q = upright(d, upIsZ);
    float u = (0.5f + std::atan2(q.x, -q.z) / (2 * (float)std::numbers::pi)) * (float)width - 0.5f,
          v = std::acos(std::clamp(q.y, -1.f, 1.f)) / (float)std::numbers::pi * (float)height - 0.5f;
    float left = std::floor(u), above = std::floor(v), s = u - left, t = v - above;
    auto at = [&](int i, int j) {
        return pixels[(size_t)std::clamp(j, 0, height - 1) * (size_t)width + (size_t)((i + width) % width)];
    };
    int i = (int)left, j = (int)above;
    return (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) +
           (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t;
}

SkyPicture evenSky(const Rgb &radiance) { return {1, 1, {radiance}, false}; }

Vec3 sunTowards(double elevation, double azimuth, bool upIsZ) {
    double up = elevation * std::numbers::pi / 180, around = azimuth * std::numbers::pi / 180;
    Vec3 towards = {(float)(std::cos(up) * std::sin(around)), (float)std::sin(up),
                    (float)(-std::cos(up) * std::cos(around))};
    return asInModel(towards, upIsZ);
}

void Surroundings::moveTo(const Vec3 &origin) {
    for (BallLamp &lamp : lamps)
        lamp.centre = toFloat(toDouble(lamp.centre) - toDouble(origin) + toDouble(lamp.rest)), lamp.rest = {};
}

void Surroundings::scale(double by) {
    for (BallLamp &lamp : lamps)
        lamp = ballLamp((toDouble(lamp.centre) + toDouble(lamp.rest)) * by, (double)lamp.radius * by,
                        lamp.radiance);
}

BallLamp ballLamp(const Vec3d &centre, double radius, const Rgb &radiance) {
    return {toFloat(centre), (float)radius, radiance, toFloat(centre - toDouble(toFloat(centre)))};
}

pictures::Picture readPanorama(const std::string &path, std::vector<std::string> *notes) {
    pictures::Picture p = pictures::readPicture(path);
    p.needUsual(path);
    if (!notes) return p;
    for (const auto &[what, hash] : p.unused) notes->push_back(path + ": " + what + " is not used");
    if (p.width != 2 * p.height)
        notes->push_back(path + common::format(": it is %d x %d, not twice as wide as high, and is read as a "
                                               "panorama",
                                               p.width, p.height));
    return p;
}

SkyPicture readSky(const std::string &path, bool upIsZ, std::vector<Sun> &suns,
                   std::vector<std::string> *notes) {
    using std::numbers::pi;
    const pictures::Picture given = readPanorama(path, notes);
    const int width = given.width, height = given.height;
    auto solidAngle = [&](int j) { // steradians of a pixel in row j
        return 2 * pi / width * (std::cos(pi * j / height) - std::cos(pi * (j + 1) / height));
    };
    std::vector<Rgb> light;
    double mean = 0;
    for (size_t k = 0; k < given.pixels(); ++k) {
        auto [red, green, blue] = given.linear(k);
        light.push_back({std::max(red, 0.f), std::max(green, 0.f), std::max(blue, 0.f)});
        mean += totalOf(light[k]) * solidAngle((int)k / width) / (4 * pi);
    }
    // Turn what is too bright into suns
    const double limit = kTooBright * mean;
    std::vector<Glint> glints;
    for (size_t k = 0; k < light.size(); ++k) {
        const double total = totalOf(light[k]), kept = limit / total;
        if (!(total > limit)) continue;
        const int i = (int)k % width, j = (int)k / width;
        const double around = 2 * pi * ((i + 0.5) / width - 0.5), down = pi * (j + 0.5) / height;
        glints.push_back(
            {{std::sin(down) * std::sin(around), std::cos(down), -std::sin(down) * std::cos(around)},
             light[k] * (float)((1 - kept) * solidAngle(j) / pi)});
        light[k] = light[k] * (float)kept;
    }
    if (!glints.empty()) cut(glints.begin(), glints.end(), kMostSuns, upIsZ, suns);
    // Make the smaller picture, whose pixels are means over their areas
    SkyPicture sky = {kSkyWidth, kSkyHeight, std::vector<Rgb>((size_t)kSkyWidth * kSkyHeight), upIsZ};
    stbir_resize_float_generic(&light[0].x, width, height, 0, &sky.pixels[0].x, kSkyWidth, kSkyHeight, 0, 3,
                               STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP, STBIR_FILTER_BOX,
                               STBIR_COLORSPACE_LINEAR, nullptr);
    return sky;
}

} // namespace odraz::radiosity

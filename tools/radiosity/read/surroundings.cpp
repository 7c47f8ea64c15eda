#include "tools/radiosity/read/surroundings.h"

#include "base/maths.h"
#include "tools/common/text.h"
#include "tools/picture/picture_file.h"
#include "tools/radiosity/read/upright.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odraz::radiosity {

namespace {

// Size of the picture that rays sample: a pixel is about as wide as a ray's share of the directions
constexpr int kSkyWidth = 128, kSkyHeight = 64;
constexpr double kTooBright = 8; // times the mean
constexpr size_t kMostSuns = 24;

double totalOf(const Rgb &c) { return (double)c.x + (double)c.y + (double)c.z; }

struct Glint {      // the part of a pixel's light above the limit
    double x, y, z; // direction
    Rgb light;      // radiance times solid angle over pi
};

// Makes at most `parts` suns from glints: divides them repeatedly, across their largest extent, into two
// groups with equal light.
void cut(std::vector<Glint>::iterator first, std::vector<Glint>::iterator end, size_t parts, bool upIsZ,
         std::vector<Sun> &suns) {
    if (parts > 1 && end - first > 1) {
        double lo[3] = {2, 2, 2}, hi[3] = {-2, -2, -2}, all = 0;
        for (auto g = first; g != end; ++g) {
            const double at[3] = {g->x, g->y, g->z};
            for (int k = 0; k < 3; ++k) lo[k] = std::min(lo[k], at[k]), hi[k] = std::max(hi[k], at[k]);
            all += totalOf(g->light);
        }
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
        if (hi[axis] - lo[axis] > 0.02) { // about a degree; smaller groups become one sun
            auto along = [axis](const Glint &g) { return axis == 0 ? g.x : axis == 1 ? g.y : g.z; };
            std::sort(first, end, [&](const Glint &a, const Glint &b) { return along(a) < along(b); });
            auto middle = first;
            double sum = 0;
            while (middle != end - 1 && (sum += totalOf(middle->light)) < all / 2) ++middle;
            middle = std::max(middle, first + 1);
            cut(first, middle, parts / 2, upIsZ, suns);
            cut(middle, end, parts - parts / 2, upIsZ, suns);
            return;
        }
    }
    double x = 0, y = 0, z = 0;
    Rgb light = {};
    for (auto g = first; g != end; ++g) {
        double weight = totalOf(g->light);
        x += g->x * weight, y += g->y * weight, z += g->z * weight;
        light = light + g->light;
    }
    double size = std::sqrt(x * x + y * y + z * z);
    if (size > 0)
        suns.push_back({asInModel({(float)(x / size), (float)(y / size), (float)(z / size)}, upIsZ), light});
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

namespace {

// Makes the smaller picture that rays sample, and turns pixels that are too bright into suns.
class SkyReader {
public:
    SkyReader(pictures::Picture given, bool upIsZ)
        : given(std::move(given)), width(this->given.width), height(this->given.height),
          sky({kSkyWidth, kSkyHeight, std::vector<Rgb>((size_t)kSkyWidth * kSkyHeight), upIsZ}),
          weight(sky.pixels.size()) {}

    SkyPicture read(std::vector<Sun> &suns) {
        double limit = kTooBright * meanBrightness();
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                Rgb light = pixel(i, j);
                double total = totalOf(light), kept = total > limit ? limit / total : 1;
                if (kept < 1) addGlint(i, j, light * (float)((1 - kept) * solidAngle(j) / std::numbers::pi));
                spread(i, j, light * (float)kept);
            }
        for (size_t k = 0; k < weight.size(); ++k)
            if (weight[k] > 0) sky.pixels[k] = sky.pixels[k] * (float)(1 / weight[k]);
        if (!glints.empty()) cut(glints.begin(), glints.end(), kMostSuns, sky.upIsZ, suns);
        return std::move(sky);
    }

private:
    pictures::Picture given;
    int width, height;
    SkyPicture sky;
    std::vector<double> weight; // for each pixel of `sky`: the area covered so far
    std::vector<Glint> glints;

    Rgb pixel(int i, int j) const {
        auto [red, green, blue] = given.linear((size_t)j * (size_t)width + (size_t)i);
        return {std::max(red, 0.f), std::max(green, 0.f), std::max(blue, 0.f)};
    }
    double solidAngle(int j) const { // solid angle of a pixel in row j
        return 2 * std::numbers::pi / width *
               (std::cos(std::numbers::pi * j / height) - std::cos(std::numbers::pi * (j + 1) / height));
    }
    double meanBrightness() const {
        double mean = 0;
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                mean += totalOf(pixel(i, j)) * solidAngle(j) / (4 * std::numbers::pi);
        return mean;
    }

    void addGlint(int i, int j, const Rgb &light) {
        double around = 2 * std::numbers::pi * ((i + 0.5) / width - 0.5),
               down = std::numbers::pi * (j + 0.5) / height;
        glints.push_back(
            {std::sin(down) * std::sin(around), std::cos(down), -std::sin(down) * std::cos(around), light});
    }

    // Adds a pixel to the pixels of the smaller picture that it covers.
    void spread(int i, int j, const Rgb &light) {
        int x0 = i * kSkyWidth / width, x1 = std::max(x0 + 1, ((i + 1) * kSkyWidth + width - 1) / width),
            y0 = j * kSkyHeight / height, y1 = std::max(y0 + 1, ((j + 1) * kSkyHeight + height - 1) / height);
        auto overlap = [](int at, int count, int to, int of) { // length of the overlap, in [0, 1]
            return std::max(std::min((at + 1.) / count, (to + 1.) / of) -
                                std::max((double)at / count, (double)to / of),
                            0.);
        };
        for (int y = y0; y < std::min(y1, kSkyHeight); ++y)
            for (int x = x0; x < std::min(x1, kSkyWidth); ++x) {
                double share = overlap(i, width, x, kSkyWidth) * overlap(j, height, y, kSkyHeight);
                size_t k = (size_t)y * kSkyWidth + (size_t)x;
                sky.pixels[k] = sky.pixels[k] + light * (float)share;
                weight[k] += share;
            }
    }
};

} // namespace

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
    return SkyReader(readPanorama(path, notes), upIsZ).read(suns);
}

} // namespace odraz::radiosity

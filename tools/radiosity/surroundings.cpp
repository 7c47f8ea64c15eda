#include "tools/radiosity/surroundings.h"

#include "base/maths.h"
#include "radiosity/visible.h"
#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/upright.h"
#include "trace/rays/intersect.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odraz {

namespace {

constexpr double kPiD = 3.14159265358979;
constexpr int kSkyWidth = 128,
              kSkyHeight = 64;   // of the picture that rays look at: as wide as what each stands for
constexpr double kTooBright = 8; // times the mean
constexpr size_t kMostSuns = 24;

double bright(const Rgb &c) { return (double)c.x + (double)c.y + (double)c.z; }

struct Glint {      // a pixel's light beyond what the sky keeps
    double x, y, z; // direction
    Rgb light;      // times its solid angle over pi
};

// Splits glints at the middle of their light, across the axis along which they spread most, until there are
// enough parts.
void cut(std::vector<Glint>::iterator first, std::vector<Glint>::iterator end, size_t parts, bool upIsZ,
         std::vector<Sun> &suns) {
    if (parts > 1 && end - first > 1) {
        double lo[3] = {2, 2, 2}, hi[3] = {-2, -2, -2}, all = 0;
        for (auto g = first; g != end; ++g) {
            const double at[3] = {g->x, g->y, g->z};
            for (int k = 0; k < 3; ++k) lo[k] = std::min(lo[k], at[k]), hi[k] = std::max(hi[k], at[k]);
            all += bright(g->light);
        }
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
        if (hi[axis] - lo[axis] > 0.02) { // a degree: less is one sun
            auto along = [axis](const Glint &g) { return axis == 0 ? g.x : axis == 1 ? g.y : g.z; };
            std::sort(first, end, [&](const Glint &a, const Glint &b) { return along(a) < along(b); });
            auto middle = first;
            double sum = 0;
            while (middle != end - 1 && (sum += bright(middle->light)) < all / 2) ++middle;
            middle = std::max(middle, first + 1);
            cut(first, middle, parts / 2, upIsZ, suns);
            cut(middle, end, parts - parts / 2, upIsZ, suns);
            return;
        }
    }
    double x = 0, y = 0, z = 0;
    Rgb light = {};
    for (auto g = first; g != end; ++g) {
        double weight = bright(g->light);
        x += g->x * weight, y += g->y * weight, z += g->z * weight;
        light = light + g->light;
    }
    double size = std::sqrt(x * x + y * y + z * z);
    if (size > 0)
        suns.push_back({asInModel({(float)(x / size), (float)(y / size), (float)(z / size)}, upIsZ), light});
}

// Radiance's format: lines of text up to an empty one, a line with height and width, and rows of pixels, each
// of them plain or run by run in four planes (Ward, "Real Pixels", Graphics Gems II, 1991). Three floats a
// pixel.
std::vector<float> readHdr(const std::string &path, const std::string &file, int &width, int &height) {
    auto refuse = [&](const char *what) { throw Refused(path + ": " + what); };
    size_t at = file.find("\n\n");
    int read = 0;
    if (file.compare(0, 2, "#?") || at == std::string::npos ||
        std::sscanf(file.c_str() + at + 2, "-Y %d +X %d%n", &height, &width, &read) != 2 || !read)
        refuse("is no picture in Radiance's HDR format, upright and from the left");
    if (width < 1 || height < 1 || (int64_t)width * height > 1 << 27)
        refuse("has no pixels, or more than 2^27");
    at += 3 + (size_t)read;
    auto next = [&] {
        if (at >= file.size()) refuse("ends before its last pixel");
        return (uint8_t)file[at++];
    };
    std::vector<float> pixels;
    std::vector<uint8_t> row((size_t)width * 4);
    for (int j = 0; j < height; ++j) {
        for (size_t k = 0; k < 4; ++k) row[k] = next();
        if (width >= 8 && width < 32768 && row[0] == 2 && row[1] == 2 && row[2] * 256 + row[3] == width) {
            for (size_t k = 0; k < 4; ++k)
                for (int i = 0; i < width;) {
                    int count = next(), run = count > 128;
                    if (run) count -= 128;
                    if (count == 0 || i + count > width) refuse("is damaged: a run is longer than its row");
                    uint8_t value = run ? next() : 0;
                    for (; count; --count, ++i) row[(size_t)i * 4 + k] = run ? value : next();
                }
        } else {
            for (size_t k = 4; k < row.size(); ++k) row[k] = next();
        }
        for (size_t i = 0; i < (size_t)width; ++i) {
            const uint8_t *p = &row[i * 4];
            for (size_t k = 0; k < 3; ++k) pixels.push_back(p[3] ? std::ldexp((float)p[k], p[3] - 136) : 0);
        }
    }
    return pixels;
}

} // namespace

Rgb SkyPicture::radiance(const Vec3 &d) const {
    if (!width) return {};
    if (width == 1) return pixels[0];
    Vec3 q = upright(d, upIsZ);
    float u = (0.5f + std::atan2(q.x, -q.z) / (2 * (float)kPiD)) * (float)width - 0.5f,
          v = std::acos(std::clamp(q.y, -1.f, 1.f)) / (float)kPiD * (float)height - 0.5f;
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
    double up = elevation * kPiD / 180, around = azimuth * kPiD / 180;
    Vec3 towards = {(float)(std::cos(up) * std::sin(around)), (float)std::sin(up),
                    (float)(-std::cos(up) * std::cos(around))};
    return asInModel(towards, upIsZ);
}

SkyPicture readSky(const std::string &path, bool upIsZ, std::vector<Sun> &suns) {
    int width = 0, height = 0;
    std::vector<float> given = readHdr(path, readWhole(path), width, height);

    // Light of each row's pixels by their solid angle; the mean tells what is too bright
    double all = 0;
    auto angle = [&](int j) { // of a pixel
        return 2 * kPiD / width * (std::cos(kPiD * j / height) - std::cos(kPiD * (j + 1) / height));
    };
    auto pixel = [&](int i, int j) {
        const float *p = &given[((size_t)j * (size_t)width + (size_t)i) * 3];
        return Rgb{p[0], p[1], p[2]};
    };
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) all += bright(pixel(i, j)) * angle(j) / (4 * kPiD);
    std::vector<Glint> glints;
    SkyPicture sky = {kSkyWidth, kSkyHeight, std::vector<Rgb>((size_t)kSkyWidth * kSkyHeight), upIsZ};
    std::vector<double> weight(sky.pixels.size());
    // Every pixel goes to those of the smaller picture that it covers; a large one to several
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            Rgb light = pixel(i, j);
            double much = bright(light), kept = much > kTooBright * all ? kTooBright * all / much : 1;
            if (kept < 1) {
                double around = 2 * kPiD * ((i + 0.5) / width - 0.5), down = kPiD * (j + 0.5) / height;
                glints.push_back({std::sin(down) * std::sin(around), std::cos(down),
                                  -std::sin(down) * std::cos(around),
                                  light * (float)((1 - kept) * angle(j) / kPiD)});
            }
            light = light * (float)kept;
            int x0 = i * kSkyWidth / width, x1 = std::max(x0 + 1, ((i + 1) * kSkyWidth + width - 1) / width),
                y0 = j * kSkyHeight / height,
                y1 = std::max(y0 + 1, ((j + 1) * kSkyHeight + height - 1) / height);
            for (int y = y0; y < std::min(y1, kSkyHeight); ++y)
                for (int x = x0; x < std::min(x1, kSkyWidth); ++x) {
                    auto share = [](int at, int count, int to, int of) { // overlap of two intervals of [0, 1]
                        return std::min((at + 1.) / count, (to + 1.) / of) -
                               std::max((double)at / count, (double)to / of);
                    };
                    double w = std::max(share(i, width, x, kSkyWidth), 0.) *
                               std::max(share(j, height, y, kSkyHeight), 0.);
                    size_t k = (size_t)y * kSkyWidth + (size_t)x;
                    sky.pixels[k] = sky.pixels[k] + light * (float)w;
                    weight[k] += w;
                }
        }
    for (size_t k = 0; k < weight.size(); ++k)
        if (weight[k] > 0) sky.pixels[k] = sky.pixels[k] * (float)(1 / weight[k]);
    if (!glints.empty()) cut(glints.begin(), glints.end(), kMostSuns, upIsZ, suns);
    return sky;
}

void addSky(const Model &model, const Scene &scene, const SkyPicture &sky, int rays, Workers &workers,
            float *const *direct) {
    // Directions about the normal, of each of four rounds: every fourth of a grid's, mapped to the disc so
    // that squares stay square (Shirley and Chiu, 1997), and from there straight up
    int across = (int)std::lround(std::sqrt(rays));
    std::vector<Vec3> rounds[4];
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
            double a = 2 * (i + 0.5) / across - 1, b = 2 * (j + 0.5) / across - 1, r, angle;
            if (std::fabs(a) > std::fabs(b))
                r = a, angle = kPiD / 4 * (b / a);
            else
                r = b, angle = kPiD / 2 - (b != 0 ? kPiD / 4 * (a / b) : 0);
            rounds[(i & 1) + 2 * (j & 1)].push_back({(float)(r * std::cos(angle)),
                                                     (float)(r * std::sin(angle)),
                                                     (float)std::sqrt(std::max(1 - r * r, 0.))});
        }
    parallelRanges(workers, model.texelCount, 64, [&](int first, int end, int) {
        for (int i = first; i < end; i += 8) {
            int count = std::min(end - i, 8), numbers[8], seen[8] = {};
            Float8 cosine, sine;
            for (int k = 0; k < 8; ++k) {
                numbers[k] = i + std::min(k, count - 1);
                if (k < count) seen[k] = model.texels[numbers[k]].visible;
                uint32_t hash = (uint32_t)numbers[k] * 2654435761u;
                float turn = (float)(hash >> 8) * (float)(2 * kPiD / (1 << 24));
                cosine[k] = std::cos(turn), sine[k] = std::sin(turn);
            }
            Texels8 t = loadTexels(model, numbers, count);
            Rgb sums[8] = {};
            float looked[8] = {};
            for (int round = 0; round < 4; ++round) {
                Places8 places = placesOf(seen, round);
                if (!any(places.active)) break;
                Vec3x8 from = t.at(places.x, places.y);
                Vec3x8 u = t.u * cosine + t.v * sine, v = t.v * cosine - t.u * sine;
                for (const Vec3 &local : rounds[round]) {
                    Vec3x8 d = u * broadcast(local.x) + v * broadcast(local.y) + t.n * broadcast(local.z);
                    Float8 open =
                        transmittance(scene, {from, d}, broadcast(kFar), places.active, broadcast(-1)).y;
                    for (int k = 0; k < count; ++k) {
                        if (!places.active[k]) continue;
                        looked[k] += 1;
                        if (open[k] > 0) sums[k] = sums[k] + sky.radiance({d.x[k], d.y[k], d.z[k]}) * open[k];
                    }
                }
            }
            for (int k = 0; k < count; ++k) {
                Rgb mean = sums[k] * (1 / std::max(looked[k], 1.f));
                direct[0][i + k] += mean.x, direct[1][i + k] += mean.y, direct[2][i + k] += mean.z;
            }
        }
    });
}

} // namespace odraz

#include "tools/radiosity/transfer/environment.h"

#include "tools/common/text.h"
#include "tools/radiosity/read/upright.h"
#include "tools/radiosity/solve/solve_options.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace odraz::radiosity {

namespace {

constexpr int kLeastRows = 128; // smaller pictures are subdivided to this number of rows
constexpr int kPictureRows = 512;

// The directions of eight pixels of a row, from column `first` on. `y` is the row's height on the unit
// sphere.
Vec3x8 directionsOf(double y, int first, int columns, bool upIsZ) {
    Vec3x8 d;
    double r = std::sqrt(std::max(1 - y * y, 0.));
    for (int k = 0; k < 8; ++k) {
        double around = 2 * std::numbers::pi * ((first + k + 0.5) / columns - 0.5);
        Vec3 q = asInModel({(float)(r * std::sin(around)), (float)y, (float)(-r * std::cos(around))}, upIsZ);
        d.x[k] = q.x, d.y[k] = q.y, d.z[k] = q.z;
    }
    return d;
}

} // namespace

Projected project(const pictures::Picture &picture, bool upIsZ) {
    int parts = (kLeastRows + picture.height - 1) / picture.height,
        partsAround = (2 * kLeastRows + picture.width - 1) / picture.width;
    int rows = picture.height * parts, columns = picture.width * partsAround;
    double sum[kMostSh][3] = {}, energy = 0;
    for (int j = 0; j < rows; ++j) {
        double above = std::cos(std::numbers::pi * j / rows),
               below = std::cos(std::numbers::pi * (j + 1) / rows);
        double solidAngle = 2 * std::numbers::pi / columns * (above - below), y = (above + below) / 2;
        size_t line = (size_t)(j / parts) * (size_t)picture.width;
        for (int first = 0; first < columns; first += 8) {
            Float8 basis[kMostSh];
            evaluateBands(directionsOf(y, first, columns, upIsZ), kMostBands, basis);
            for (int k = 0; k < std::min(8, columns - first); ++k) {
                auto pixel = picture.linear(line + (size_t)((first + k) / partsAround));
                for (size_t c = 0; c < 3; ++c) {
                    double light = (double)pixel[c] * solidAngle;
                    energy += light * (double)pixel[c];
                    for (int i = 0; i < kMostSh; ++i) sum[i][c] += light * (double)basis[i][k];
                }
            }
        }
    }
    Projected p;
    double kept = 0;
    for (int i = 0; i < kMostSh; ++i) {
        p.light[(size_t)i] = {(float)sum[i][0], (float)sum[i][1], (float)sum[i][2]};
        for (double x : sum[i]) kept += x * x;
        p.held[bandOf(i)] = energy > 0 ? std::min(kept / energy, 1.) : 1;
    }
    return p;
}

Projected project(const Rgb &even) {
    Projected p;
    p.light[0] = even * (float)std::sqrt(4 * std::numbers::pi);
    std::fill(std::begin(p.held), std::end(p.held), 1.);
    return p;
}

SkyPicture pictureOf(const BandLight &light, int bands, bool upIsZ) {
    SkyPicture sky = {2 * kPictureRows, kPictureRows, {}, upIsZ};
    for (int j = 0; j < sky.height; ++j)
        for (int first = 0; first < sky.width; first += 8) {
            double y = std::cos(std::numbers::pi * (j + 0.5) / sky.height);
            Float8 basis[kMostSh];
            evaluateBands(directionsOf(y, first, sky.width, upIsZ), bands, basis);
            Rgb8 sum = {};
            for (int k = 0; k < bands * bands; ++k) sum = fmadd(broadcast(light[(size_t)k]), basis[k], sum);
            for (int k = 0; k < 8; ++k) sky.pixels.push_back({sum.x[k], sum.y[k], sum.z[k]});
        }
    return sky;
}

Projected readEnvironment(const std::string &sky, bool upIsZ, std::vector<std::string> *notes) {
    if (std::optional<Rgb> even = evenRadiance(sky)) return project(*even);
    pictures::Picture picture = readPanorama(sky, notes);
    for (float &x : picture.light) x = std::max(x, 0.f);
    return project(picture, upIsZ);
}

std::string bandLossText(const std::string &name, const Projected &p, int bands) {
    double held = p.held[bands - 1];
    return name + common::format(bands == 1 ? ": %d band holds %.1f %% of its energy and loses %.1f %%"
                                            : ": %d bands hold %.1f %% of its energy and lose %.1f %%",
                                 bands, 100 * held, 100 * (1 - held));
}

} // namespace odraz::radiosity

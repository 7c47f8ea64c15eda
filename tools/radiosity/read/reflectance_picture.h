// Pictures that give the reflectance of materials, averaged over polygons in linear light.
#pragma once

#include "tools/picture/picture.h"
#include "trace/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace odraz::radiosity {

// Coordinates on a picture: 0 .. 1 from left to right and from bottom to top.
using TexturePoint = std::array<double, 2>;

class ReflectancePicture {
public:
    // Values beyond 0 .. 1 become 0 or 1.
    explicit ReflectancePicture(const pictures::Picture &picture);

    // The mean over a convex polygon, or the value at its middle if it has no area. Outside 0 .. 1 the
    // picture repeats, or with `clamp` its border does. Large polygons use a coarser level, so that a mean
    // reads a few hundred texels at most.
    Rgb mean(const std::vector<TexturePoint> &polygon, bool clamp) const;
    Rgb mean() const; // mean of the whole picture

private:
    struct Level {
        int width, height;
        std::vector<std::array<uint16_t, 3>> texels; // 65535 is 1
    };
    std::vector<Level> levels; // the last one has a single texel

    static Level halved(const Level &of);
    static Rgb texel(const Level &level, int64_t i, int64_t j, bool clamp);
};

} // namespace odraz::radiosity

// Pictures: as a file holds them, and as eight-bit RGB.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pictures {

struct Image {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb; // sRGB, 3 * width * height bytes, top row first
};

// As a file holds it, top row first: numbers encoded as sRGB, or floats that are linear. The channels are
// grey, grey and alpha, RGB, or RGB and alpha.
struct Picture {
    int width = 0, height = 0, channels = 3;
    int bits = 8;                       // of a number in the file
    std::vector<uint16_t> encoded = {}; // 65535 is 1; empty if there are floats
    std::vector<float> light = {};      // 1 is white
    std::string others = {};            // the names of all channels, if some are not read
    // What else the file says of its numbers, unless that is usual: by name, with a hash of its bytes. It is
    // not used
    std::map<std::string, uint64_t> unused = {};

    size_t pixels() const { return (size_t)width * (size_t)height; }
    void leave(const std::string &name, std::string_view bytes); // adds to `unused`
    // Throws Refused for floats with anything that is not used: they would be other light
    void needUsual(const std::string &name) const;
    bool hasAlpha() const { return channels % 2 == 0; }
    // Red, green, blue and alpha, 255 for 1; 255 without alpha
    std::array<double, 4> steps(size_t pixel) const;
    // Linear red, green and blue
    std::array<float, 3> linear(size_t pixel) const;
};

// The largest size that is read: a sky of 16,384 x 8,192.
constexpr int64_t kMostPixels = 1 << 27;

// The most light that is read, here and from models and options: sums must fit into a float.
constexpr double kMostLight = 1e12;

// Rounded to the nearest. Floats are encoded as sRGB; alpha is left out.
Image toImage(const Picture &picture);

// The same of numbers that are linear, not sRGB, each pixel the mean of `by` x `by`. Throws Refused if the
// size is no multiple of `by`.
Image linearToImage(const Picture &picture, int by);

// Writes a PNG whole or not at all. Throws std::runtime_error.
void writePng(const std::string &path, const Image &picture);

// Shrinks by averaging areas; `width` is at most the picture's own.
Image shrink(const Image &picture, int width);

} // namespace pictures

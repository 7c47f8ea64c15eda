// Pictures: as stored in a file, and as eight-bit RGB.
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

// A picture as stored in a file, top row first: whole numbers encoded as sRGB, or linear floats. The channels
// are grey, grey and alpha, RGB, or RGB and alpha.
struct Picture {
    int width = 0, height = 0, channels = 3;
    int bits = 8;                       // per number in the file
    std::vector<uint16_t> encoded = {}; // 65535 is 1; empty if there are floats
    std::vector<float> light = {};      // 1 is white
    std::string others = {};            // the names of all channels, if some are not read
    // Hashes, by name, of the file's statements about its pixels that are neither used nor usual
    std::map<std::string, uint64_t> unused = {};

    size_t pixels() const { return (size_t)width * (size_t)height; }
    void leave(const std::string &name, std::string_view bytes); // adds a statement to `unused`
    // Throws Refused if these are floats and a statement is unused, since the light would be wrong
    void needUsual(const std::string &name) const;
    bool hasAlpha() const { return channels % 2 == 0; }
    // Red, green, blue and alpha in steps of 1/255; alpha is 255 if there is none
    std::array<double, 4> steps(size_t pixel) const;
    // Linear red, green and blue
    std::array<float, 3> linear(size_t pixel) const;
};

// Converts CIE XYZ to linear red, green and blue with sRGB's primaries and white (IEC 61966-2-1).
std::array<double, 3> rgbOfXyz(const std::array<double, 3> &xyz);

// The largest readable picture: a sky of 16,384 x 8,192.
constexpr int64_t kMostPixels = 1 << 27;

// The largest light value that is accepted, here and from models and options, so that sums fit into a float.
constexpr double kMostLight = 1e12;

// Converts to eight bits, rounded to the nearest. Floats are encoded as sRGB; alpha is dropped.
Image toImage(const Picture &picture);

// Converts a picture whose numbers are linear, not sRGB. Each pixel is the mean of `by` x `by` pixels. Throws
// Refused if the size is no multiple of `by`.
Image linearToImage(const Picture &picture, int by);

// Writes a file whole or not at all. Throws std::runtime_error.
void writePng(const std::string &path, const Image &picture);

// Writes linear red, green and blue, the top row first, as OpenEXR of 32-bit floats. Throws likewise.
void writeExr(const std::string &path, int width, int height, const std::vector<float> &rgb);

// The format that the name of an output asks for, in capitals or not: PNG, also without an ending, or
// `other`. Throws Refused for another ending, because a picture would have the wrong name.
enum class Format { Png, Jpeg, Exr };
Format formatNamed(const std::string &path, Format other = Format::Png);

// Writes PNG or JPEG, by the name, likewise.
void writeImage(const std::string &path, const Image &picture);

// Shrinks a picture to `width` by averaging areas. It is never enlarged.
Image shrink(const Image &picture, int width);

} // namespace pictures

// Reads and writes pictures of eight-bit RGB.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace pictures {

struct Image {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb; // 3 * width * height bytes, top row first
};

// Reads PNG, PPM and the other formats of stb_image. Throws Refused if the file is no such picture.
Image readPicture(const std::string &path);

// Reads a linear PNG of 16 bits, which other tracers write. Averages squares of `by` x `by` pixels and
// encodes them as sRGB, rounded to the nearest. Throws Refused if the file is no picture, or its size is no
// multiple of `by`.
Image readLinear(const std::string &path, int by);

// Reads one binary PPM from a stream; false at the end of the stream or if the picture is damaged.
bool readPpm(std::FILE *stream, Image &picture);

// Writes a PNG whole or not at all. Throws std::runtime_error.
void writePng(const std::string &path, const Image &picture);

// Shrinks by averaging areas; `width` is at most the picture's own.
Image shrink(const Image &picture, int width);

} // namespace pictures

// Reads and writes pictures of eight-bit RGB.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb; // 3 * width * height bytes, top row first
};

// Reads PNG, PPM and the other formats of stb_image; false if the file is no such picture.
bool readPicture(const std::string &path, Picture &picture);

// Reads a linear PNG of 16 bits, which other tracers write. Averages squares of `by` x `by` pixels and
// encodes them as sRGB, rounded to the nearest. False if the file is no picture, or its size is no multiple
// of `by`.
bool readLinear(const std::string &path, int by, Picture &picture);

// Reads one binary PPM from a stream; false at the end of the stream or if the picture is damaged.
bool readPpm(std::FILE *stream, Picture &picture);

// Writes a PNG beside `path` and renames it; false if it cannot be written.
bool writePng(const std::string &path, const Picture &picture);

// Shrinks by averaging areas; `width` is at most the picture's own.
Picture shrink(const Picture &picture, int width);

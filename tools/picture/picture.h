// Pictures of eight-bit RGB in files.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb; // 3 * width * height bytes, top row first
};

// Reads PNG, PPM and what else stb_image knows; false when it is not a picture.
bool readPicture(const std::string &path, Picture &picture);

// Reads a PNG of 16 bits that are linear (other tracers write those), averages squares of `by` x `by` of its
// pixels, and encodes sRGB rounded to the nearest; false when it is not a picture that can be so divided.
bool readLinear(const std::string &path, int by, Picture &picture);

// Reads one binary PPM from a stream; false at its end or when it is damaged.
bool readPpm(std::FILE *stream, Picture &picture);

// Writes a PNG beside `path` and renames it; false when it cannot be written.
bool writePng(const std::string &path, const Picture &picture);

// Smaller by averaging areas; to a width of at most the picture's own.
Picture shrink(const Picture &picture, int width);

// FLIP: what somebody sees who flips between a picture and its reference; 0 nothing, 1 as much as can be.
//
// LDR-FLIP of Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", HPG 2020, which the step titles follow, for a screen of 3840 pixels seen
// from as far as it is wide: 67 pixels per degree.
#pragma once

#include <cstdint>
#include <vector>

namespace odraz {

// A picture as the eye has it: made once, compared often.
struct SeenPicture {
    int width, height;
    std::vector<float> lightness, a, b; // filtered as the eye does, Hunt-adjusted CIELAB
    std::vector<float> edges, points;   // how strong they are
};

// `rgb`: eight-bit sRGB, 3 bytes a pixel, top row first.
SeenPicture see(const std::vector<uint8_t> &rgb, int width, int height);

// The difference at every pixel, 0 .. 1. Both are of one size.
std::vector<float> flip(const SeenPicture &reference, const SeenPicture &test);
double meanFlip(const SeenPicture &reference, const SeenPicture &test);

} // namespace odraz

// FLIP: the visible difference when flipping between a picture and its reference, from 0 to 1.
//
// LDR-FLIP of Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", HPG 2020; the step titles follow the paper. The screen is 3840 pixels
// wide and is seen from a distance equal to its width: 67 pixels per degree.
#pragma once

#include <cstdint>
#include <vector>

namespace pictures {

// A picture as the eye perceives it. It is made once and compared often.
struct SeenPicture {
    int width, height;
    std::vector<float> lightness, a, b; // filtered by contrast sensitivity; Hunt-adjusted CIELAB
    std::vector<float> edges, points;   // feature strengths
};

// `rgb`: eight-bit sRGB, 3 bytes a pixel, top row first.
SeenPicture see(const std::vector<uint8_t> &rgb, int width, int height);

// Returns the difference at every pixel, 0 .. 1. Both pictures must have the same size.
std::vector<float> flip(const SeenPicture &reference, const SeenPicture &test);
double meanFlip(const SeenPicture &reference, const SeenPicture &test);

} // namespace pictures

// Solid textures: a pattern of local points, looked up in a palette.
//
// A pattern gives a number in [0, 1]; a palette of four evenly spaced colours turns it into a colour.
// Patterns are band-limited to the sample's width: octaves fade before they alias. A new pattern needs an
// enumerator, a row of kPatterns, and a case in valueOf() (pattern.cpp).
#pragma once

#include "base/rows.h"
#include "base/vec3.h"

namespace odraz {

enum class Pattern : uint8_t { Plain, Marble, Wood, WoodAcross, Stone, Plaster, Tubes, Count };

// The properties of a pattern that other code depends on.
struct PatternTraits {
    Pattern pattern;
    bool faint = false; // so fine or pale that samples and mirrors may show its mean: see Quality::faint
    float shares[4];    // each palette colour's share of space, measured by texture_test
};

inline constexpr PatternTraits kPatterns[] = {
    {.pattern = Pattern::Plain, .shares = {1, 0, 0, 0}}, // the first colour alone
    {.pattern = Pattern::Marble, .shares = {18 / 64.f, 42 / 64.f, 3.5f / 64, 0.5f / 64}},
    {.pattern = Pattern::Wood, .shares = {12.5f / 64, 35.5f / 64, 14.5f / 64, 1.5f / 64}}, // grows along z
    {.pattern = Pattern::WoodAcross, .shares = {12.5f / 64, 35.5f / 64, 14.5f / 64, 1.5f / 64}}, // along x
    {.pattern = Pattern::Stone, .faint = true, .shares = {7 / 64.f, 18.5f / 64, 24.5f / 64, 14 / 64.f}},
    {.pattern = Pattern::Plaster, .faint = true, .shares = {1.5f / 64, 40.5f / 64, 22 / 64.f, 0}},
    {.pattern = Pattern::Tubes,
     .shares = {17.5f / 64, 14 / 64.f, 9.5f / 64, 23 / 64.f}}, // circles around the x axis
};
static_assert(inOrder(kPatterns, &PatternTraits::pattern), "a row for every pattern, in the enum's order");

struct Texture {
    Pattern pattern;
    float scale; // lattice cells per world unit
    Rgb palette[4];

    const PatternTraits &traits() const { return kPatterns[(int)pattern]; }
};

// The colours at local points, averaged over samples `width` wide (world units).
Rgb8 colour(const Texture &texture, const Vec3x8 &p, Float8 width);

// The average colour over all of space.
Rgb meanColour(const Texture &texture);

} // namespace odraz

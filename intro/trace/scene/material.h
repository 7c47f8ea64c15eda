// What a surface looks like: a solid texture for the diffuse colour, and Phong and Fresnel numbers.
//
// Textures are functions of the local point, band-limited to the width that a sample covers there: octaves
// fade before they alias, checkers are box-filtered in closed form. Source: Perlin, "Improving Noise", 2002,
// for the noise under them.
#pragma once

#include "base/vec3.h"

namespace odraz {

enum class Pattern : uint8_t {
    Plain,
    Marble,
    Wood,
    WoodAcross,
    Stone,
    Cloud
}; // wood grows along z; across: x

// A pattern gives a number in [0, 1]; the palette's four evenly spaced colours make it a colour.
struct Texture {
    Pattern pattern;
    float scale; // lattice cells per world unit
    Rgb palette[4];
};

struct Material {
    Texture texture; // the diffuse colour
    Texture other;   // that of every second cell of a checker in the local x and z
    float cell;      // side of a checker's cell, world units; 0: no checker
    float diffuse;   // r_d, weight of the diffuse colour
    float specular;  // r_s, weight of Phong's highlight
    float exponent;  // h >= 1, Phong's
    float reflect;   // mirror reflectance at normal incidence, 0 .. 1
    bool fresnel;    // reflectance rises to 1 at grazing angles (Schlick)
    float ior;       // > 0: glass of this index of refraction; 0: opaque
    Rgb absorb;      // glass: absorption per world unit, in powers of two
    Rgb tint;        // colour of the mirror; of glass for shadow rays
    Rgb emit;        // light of its own, for the eye only
    float transmit =
        0; // glass: 0: Fresnel's weights, exactly; > 0: this share is refracted, `reflect` mirrored
};

// The diffuse colour at local points q seen along the local unit direction d by samples `width` wide (world
// units, across the direction), and in `cell` a number that tells cells of a checker apart.
Rgb8 albedo(const Material &material, const Vec3x8 &q, const Vec3x8 &d, Float8 cosine, Float8 width,
            Int8 &cell);

// The average colour: for judging how much a change of light shows, and for radiosity.
Rgb meanAlbedo(const Material &material);

} // namespace odraz

// What a surface looks like: a solid texture for the diffuse colour, and parameters of Phong's highlight, of
// mirrors and of glass.
//
// Textures are functions of the local point, band-limited to the width that a sample covers there; checkers
// are box-filtered in closed form.
#pragma once

#include "trace/texture/pattern.h"

namespace odraz {

struct Material {
    Texture texture = {}; // the diffuse colour
    Texture other = {};   // with a checker (in local x and z): the colour of every second cell
    float cell = 0;       // side of a checker's cell, world units; 0: no checker
    float diffuse = 0;    // r_d, weight of the diffuse colour
    float specular = 0;   // r_s, weight of Phong's highlight
    float exponent = 1;   // Phong's h, >= 1
    float reflect = 0;    // mirror reflectance at normal incidence, 0 .. 1
    bool fresnel = false; // reflectance rises to 1 at grazing angles (Schlick)
    float ior = 0;        // > 0: glass of this index of refraction; 0: opaque
    Rgb absorb = {};      // glass: absorption per world unit, in powers of two
    Rgb tint = {1, 1, 1}; // colour of a mirror, of glass for shadow rays, or of a lamp that is seen directly
    Rgb emit = {};        // radiance that it emits; it lights no other surface

    // Whether it only glows: it emits light, but reflects none, neither diffusely nor as a mirror.
    bool onlyGlows() const { return maxComponent(emit) > 0 && diffuse == 0 && reflect == 0; }
    // Whether it has one colour everywhere.
    bool plain() const { return texture.pattern == Pattern::Plain && cell == 0; }
    // Whether its texture is so fine or pale that samples in draft and play have its mean.
    bool faint() const { return texture.traits().faint && cell == 0; }
};

// The diffuse colour at local points q, seen along the local unit direction d by samples `width` wide
// (world units, across d). `cosine` is between d and the normal. `cell` gets a number that differs between
// neighbouring cells of a checker.
Rgb8 albedo(const Material &material, const Vec3x8 &q, const Vec3x8 &d, Float8 cosine, Float8 width,
            Int8 &cell);

// The average colour, for radiosity and for judging how visible a change of light is.
Rgb meanAlbedo(const Material &material);

} // namespace odraz

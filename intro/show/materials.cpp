#include "show/materials.h"

namespace odraz {

static constexpr Texture plain(Rgb c) { return {Pattern::Plain, 1, {c, c, c, c}}; }

static constexpr Texture kBlackMarble = {
    Pattern::Marble,
    1.1f,
    {{0.010f, 0.010f, 0.012f}, {0.035f, 0.035f, 0.04f}, {0.15f, 0.14f, 0.13f}, {0.55f, 0.52f, 0.48f}}};
static constexpr Texture kWhiteMarble = {
    Pattern::Marble,
    0.9f,
    {{0.72f, 0.69f, 0.65f}, {0.62f, 0.59f, 0.55f}, {0.44f, 0.42f, 0.40f}, {0.30f, 0.29f, 0.28f}}};
static constexpr Texture kGranite = {
    Pattern::Stone,
    1.6f,
    {{0.10f, 0.10f, 0.105f}, {0.20f, 0.195f, 0.19f}, {0.34f, 0.33f, 0.32f}, {0.52f, 0.50f, 0.48f}}};
static constexpr Texture kSlate = {
    Pattern::Cloud,
    1.1f,
    {{0.05f, 0.055f, 0.065f}, {0.09f, 0.095f, 0.11f}, {0.14f, 0.145f, 0.16f}, {0.24f, 0.24f, 0.25f}}};
static constexpr Texture kOak = {
    Pattern::Wood,
    2.6f,
    {{0.40f, 0.235f, 0.11f}, {0.31f, 0.17f, 0.075f}, {0.19f, 0.095f, 0.040f}, {0.10f, 0.048f, 0.022f}}};

// {texture, other, cell, diffuse, specular, exponent, reflect, fresnel, ior, absorb, tint, emit}
Material darkMarble() { return {kBlackMarble, {}, 0, 1, 0.25f, 90, 0.04f, true, 0, {}, {1, 1, 1}, {}}; }
Material slate() { return {kSlate, {}, 0, 1, 0.1f, 30, 0.03f, true, 0, {}, {1, 1, 1}, {}}; }
Material boards() { return {kGranite, kOak, 0.6f, 1, 0.15f, 60, 0.035f, true, 0, {}, {1, 1, 1}, {}}; }
static constexpr Texture kLimestone = {
    Pattern::Stone,
    1.2f,
    {{0.74f, 0.70f, 0.63f}, {0.66f, 0.62f, 0.55f}, {0.60f, 0.56f, 0.50f}, {0.45f, 0.42f, 0.38f}}};
Material limestone() { return {kLimestone, {}, 0, 1, 0, 1, 0, false, 0, {}, {1, 1, 1}, {}}; }
Material hallFloor() {
    return {kWhiteMarble, kSlate, 1.125f, 0.85f, 0.1f, 160, 0.06f, true, 0, {}, {0.8f, 0.8f, 0.8f}, {}};
}
Material plaster(Rgb colour) { return {plain(colour), {}, 0, 1, 0, 1, 0, false, 0, {}, {1, 1, 1}, {}}; }
static Material beam(Pattern pattern) {
    Material m = {kOak, {}, 0, 1, 0, 1, 0, false, 0, {}, {1, 1, 1}, {}};
    m.texture.pattern = pattern;
    return m;
}
Material beamAlong() { return beam(Pattern::Wood); }
Material beamAcross() { return beam(Pattern::WoodAcross); }
Material granite() { return {kGranite, {}, 0, 1, 0.05f, 20, 0, false, 0, {}, {1, 1, 1}, {}}; }
Material oak() { return {kOak, {}, 0, 1, 0.2f, 50, 0.03f, true, 0, {}, {1, 1, 1}, {}}; }
Material glass() {
    return {plain({}), {}, 0, 0, 0.9f, 400, 0, false, 1.5f, {0.22f, 0.10f, 0.13f}, {0.72f, 0.80f, 0.78f}, {}};
}
Material mirror() {
    return {plain({0.5f, 0.5f, 0.5f}), {}, 0, 0.03f, 0.8f, 300, 0.86f, true, 0, {}, {0.96f, 0.97f, 1}, {}};
}
Material copper() {
    return {plain({0.72f, 0.34f, 0.18f}), {}, 0, 0.25f, 0.7f, 120, 0.55f, true, 0, {}, {1, 0.62f, 0.42f}, {}};
}
Material pearl(bool warm, float reflect) {
    Rgb own = warm ? Rgb{0.70f, 0.36f, 0.20f} : Rgb{0.55f, 0.56f, 0.58f},
        tint = warm ? Rgb{1, 0.66f, 0.46f} : Rgb{0.96f, 0.97f, 1};
    return {plain(own), {}, 0, 0.6f - 0.8f * reflect, 0.8f, 90, reflect, reflect > 0, 0, {}, tint, {}};
}
Material lamp(Rgb radiance) { return {plain({}), {}, 0, 0, 0, 1, 0, false, 0, {}, {1, 1, 1}, radiance}; }

} // namespace odraz

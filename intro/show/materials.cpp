#include "show/materials.h"

namespace odraz {

static constexpr Texture plain(Rgb c) {
    return {.pattern = Pattern::Plain, .scale = 1, .palette = {c, c, c, c}};
}

// Palettes run from the commonest colour to the rarest, or from one end of the pattern to the other.
static constexpr Texture kBlackMarble = {
    .pattern = Pattern::Marble,
    .scale = 2.3f,
    .palette = {
        {0.010f, 0.010f, 0.012f}, {0.035f, 0.035f, 0.04f}, {0.15f, 0.14f, 0.13f}, {0.42f, 0.39f, 0.35f}}};
static constexpr Texture kWhiteMarble = {
    .pattern = Pattern::Marble,
    .scale = 0.9f,
    .palette = {{0.72f, 0.69f, 0.65f}, {0.62f, 0.59f, 0.55f}, {0.44f, 0.42f, 0.40f}, {0.30f, 0.29f, 0.28f}}};
static constexpr Texture kSpeckled = {
    .pattern = Pattern::Stone,
    .scale = 1.6f,
    .palette = {
        {0.10f, 0.10f, 0.105f}, {0.20f, 0.195f, 0.19f}, {0.34f, 0.33f, 0.32f}, {0.52f, 0.50f, 0.48f}}};
static constexpr Texture kPaleStone = {
    .pattern = Pattern::Stone,
    .scale = 1.2f,
    .palette = {{0.74f, 0.70f, 0.63f}, {0.66f, 0.62f, 0.55f}, {0.60f, 0.56f, 0.50f}, {0.45f, 0.42f, 0.38f}}};
static constexpr Texture kCloud = {
    .pattern = Pattern::Cloud,
    .scale = 1.1f,
    .palette = {
        {0.05f, 0.055f, 0.065f}, {0.09f, 0.095f, 0.11f}, {0.14f, 0.145f, 0.16f}, {0.24f, 0.24f, 0.25f}}};
// Stained in patches, and grained by the trowel.
static constexpr Texture plaster(Rgb c) {
    auto times = [&](float k) { return Rgb{c.x * k, c.y * k, c.z * k}; };
    return {.pattern = Pattern::Plaster,
            .scale = 1.1f,
            .palette = {times(1.12f), times(1.02f), times(0.98f), times(0.8f)}};
}
static constexpr Texture oakBy(Pattern pattern) {
    return {.pattern = pattern,
            .scale = 4.2f,
            .palette = {{0.40f, 0.235f, 0.11f},
                        {0.31f, 0.17f, 0.075f},
                        {0.19f, 0.095f, 0.040f},
                        {0.10f, 0.048f, 0.022f}}};
}
static constexpr Texture kOakAlong = oakBy(Pattern::Wood);

const Material kDarkMarble = {.texture = kBlackMarble,
                              .diffuse = 1,
                              .specular = 0.25f,
                              .exponent = 90,
                              .reflect = 0.04f,
                              .fresnel = true};
const Material kSlate = {
    .texture = kCloud, .diffuse = 0.35f, .specular = 0.1f, .exponent = 30, .reflect = 0.03f, .fresnel = true};
const Material kBoards = {.texture = kSpeckled,
                          .other = kOakAlong,
                          .cell = 0.6f,
                          .diffuse = 1,
                          .specular = 0.15f,
                          .exponent = 60,
                          .reflect = 0.035f,
                          .fresnel = true};
const Material kLimestone = {.texture = kPaleStone, .diffuse = 1};
const Material kHallFloor = {.texture = kWhiteMarble,
                             .other = kCloud,
                             .cell = 1.125f,
                             .diffuse = 0.85f,
                             .specular = 0.1f,
                             .exponent = 160,
                             .reflect = 0.06f,
                             .fresnel = true,
                             .tint = {0.8f, 0.8f, 0.8f}};
const Material kPlaster = {.texture = plaster({0.76f, 0.73f, 0.68f}), .diffuse = 1};
const Material kWarmPlaster = {.texture = plaster({0.62f, 0.33f, 0.19f}), .diffuse = 1};
const Material kBeamAlong = {.texture = kOakAlong, .diffuse = 1};
const Material kBeamAcross = {.texture = oakBy(Pattern::WoodAcross), .diffuse = 1};
const Material kGranite = {.texture = kSpeckled, .diffuse = 1, .specular = 0.05f, .exponent = 20};
const Material kOak = {
    .texture = kOakAlong, .diffuse = 1, .specular = 0.2f, .exponent = 50, .reflect = 0.03f, .fresnel = true};
const Material kGlass = {.texture = plain({}),
                         .specular = 0.9f,
                         .exponent = 400,
                         .ior = 1.5f,
                         .absorb = {0.22f, 0.10f, 0.13f},
                         .tint = {0.72f, 0.80f, 0.78f}};
const Material kMirror = {.texture = plain({0.5f, 0.5f, 0.5f}),
                          .diffuse = 0.03f,
                          .specular = 0.8f,
                          .exponent = 300,
                          .reflect = 0.86f,
                          .fresnel = true,
                          .tint = {0.96f, 0.97f, 1}};
const Material kCopper = {.texture = plain({0.72f, 0.34f, 0.18f}),
                          .diffuse = 0.25f,
                          .specular = 0.7f,
                          .exponent = 120,
                          .reflect = 0.55f,
                          .fresnel = true,
                          .tint = {1, 0.62f, 0.42f}};

Material pearl(bool warm, float reflect) {
    Rgb own = warm ? Rgb{0.66f, 0.30f, 0.17f} : Rgb{0.55f, 0.56f, 0.58f};
    return {.texture = plain(own),
            .diffuse = 0.5f - 0.8f * reflect,
            .specular = 0.8f,
            .exponent = 300,
            .reflect = reflect,
            .fresnel = reflect > 0,
            .tint = warm ? Rgb{1, 0.66f, 0.46f} : Rgb{0.96f, 0.97f, 1}};
}
Material lamp(const Rgb &radiance) { return {.texture = plain({}), .emit = radiance}; }

Sky duskSky(float row) {
    Rgb low = {0.13f, 0.115f, 0.135f}, up = Rgb{0.015f, 0.04f, 0.11f} - low;
    Sky sky = plainSky(low, {});
    sky.slope = up * 3.f, sky.curve = up * -2.2f;
    sky.sun = normalize(kDuskSun);
    sky.near = {2.4f, 1.1f, 0.4f};
    sky.glow = {0.42f, 0.15f, 0.035f};
    sky.clouds = {0.55f, 0.20f, 0.11f};
    sky.cover = 0.4f;
    sky.drift = row * 0.004f;
    return sky;
}

} // namespace odraz

#include "show/materials.h"

namespace odraz {

// A linear colour in 256ths, which pack well.
static constexpr Rgb linear(float r, float g, float b) { return {r / 256, g / 256, b / 256}; }

static constexpr Texture plain(Rgb c) {
    return {.pattern = Pattern::Plain, .scale = 1, .palette = {c, c, c, c}};
}

// Palettes go from the commonest colour to the rarest, or from one end of the pattern to the other.
static constexpr Texture kBlackMarble = {
    .pattern = Pattern::Marble,
    .scale = 2.3f,
    .palette = {linear(2.5f, 2.5f, 3), linear(9, 9, 10), linear(38, 36, 33), linear(108, 100, 90)}};
static constexpr Texture kSlateTiles = {
    .pattern = Pattern::Plaster,
    .scale = 4,
    .palette = {linear(16, 16, 16), linear(20, 20, 24), linear(32, 32, 34), linear(48, 48, 48)}};
static constexpr Texture kWhiteMarble = {
    .pattern = Pattern::Marble,
    .scale = 0.9f,
    .palette = {linear(184, 177, 166), linear(159, 151, 141), linear(113, 108, 102), linear(77, 74, 72)}};
static constexpr Texture kSpeckled = {
    .pattern = Pattern::Stone,
    .scale = 64,
    .palette = {linear(34, 34, 34), linear(74, 72, 70), linear(84, 82, 81), linear(104, 98, 92)}};
static constexpr Texture kPaleStone = {
    .pattern = Pattern::Stone,
    .scale = 60,
    .palette = {linear(148, 140, 124), linear(158, 150, 134), linear(164, 156, 140), linear(169, 161, 145)}};
// Plaster that is stained in patches and near the floor, with streaks of the trowel.
static constexpr Texture plaster(Rgb c) {
    auto times = [&](float k) { return Rgb{c.x * k, c.y * k, c.z * k}; };
    return {.pattern = Pattern::Plaster,
            .scale = 1.1f,
            .palette = {times(1.25f), times(1.0625f), times(0.9375f), times(0.75f)}};
}
static constexpr Texture oakBy(Pattern pattern) {
    return {
        .pattern = pattern,
        .scale = 10 / 3.f,
        .palette = {linear(102, 60, 28), linear(79, 44, 19), linear(49, 24, 10), linear(26, 12.5f, 5.5f)}};
}
static constexpr Texture kOakAlong = oakBy(Pattern::Wood);

const Material kDarkMarble = {.texture = kBlackMarble,
                              .diffuse = 1,
                              .specular = 0.25f,
                              .exponent = 90,
                              .reflect = 5 / 128.f,
                              .fresnel = true};
const Material kSlate = {
    .texture = plain(linear(28, 29, 33)), .diffuse = 0.375f, .reflect = 1 / 32.f, .fresnel = true};
const Material kBoards = {.texture = kSpeckled,
                          .other = kOakAlong,
                          .cell = 0.6f,
                          .diffuse = 1,
                          .specular = 5 / 32.f,
                          .exponent = 60,
                          .reflect = 1 / 32.f,
                          .fresnel = true};
const Material kLimestone = {.texture = kPaleStone, .diffuse = 1};
const Material kHallFloor = {.texture = kWhiteMarble,
                             .other = kSlateTiles,
                             .cell = 1.125f,
                             .diffuse = 27 / 32.f,
                             .specular = 3 / 32.f,
                             .exponent = 160,
                             .reflect = 1 / 16.f,
                             .fresnel = true,
                             .tint = linear(205, 205, 205)};
const Material kPlaster = {.texture = plaster(linear(194, 187, 174)), .diffuse = 1};
const Material kWarmPlaster = {.texture = plaster(linear(159, 84, 49)), .diffuse = 1};
const Material kOutside = {.texture = plaster(linear(24, 16.5f, 11.5f)), .diffuse = 1};
const Material kBeamAlong = {.texture = kOakAlong, .diffuse = 1};
const Material kBeamAcross = {.texture = oakBy(Pattern::WoodAcross), .diffuse = 1};
const Material kGranite = {.texture = kSpeckled, .diffuse = 1};
const Material kOak = {.texture = kOakAlong,
                       .diffuse = 1,
                       .specular = 3 / 16.f,
                       .exponent = 50,
                       .reflect = 1 / 32.f,
                       .fresnel = true};
const Material kGlass = {.texture = plain({}),
                         .specular = 29 / 32.f,
                         .exponent = 400,
                         .ior = 1.5f,
                         .absorb = linear(56, 26, 33),
                         .tint = linear(184, 205, 200)};
const Material kMirror = {.texture = plain({0.5f, 0.5f, 0.5f}),
                          .specular = 13 / 16.f,
                          .exponent = 300,
                          .reflect = 55 / 64.f,
                          .fresnel = true,
                          .tint = linear(246, 248, 256)};
const Material kCopper = {.texture = plain(linear(184, 87, 46)),
                          .diffuse = 0.25f,
                          .specular = 11 / 16.f,
                          .exponent = 120,
                          .reflect = 35 / 64.f,
                          .fresnel = true,
                          .tint = linear(256, 159, 108)};

Material metal(bool warm, float reflect) {
    Rgb base = warm ? linear(184, 66, 28) : linear(141, 143, 148);
    return {.texture = plain(base),
            .diffuse = 0.5f - 0.8f * reflect,
            .specular = 13 / 16.f,
            .exponent = 300,
            .reflect = reflect,
            .tint = warm ? linear(256, 169, 118) : linear(246, 248, 256)};
}
// Not inlined, to save bytes: it clears a whole material
[[gnu::noinline]] Material lamp(const Rgb &radiance) { return {.texture = plain({}), .emit = radiance}; }

void setGloom(Scene &scene, float share) {
    scene.ballsOcclude = true;
    scene.ambientLow = linear(3, 3, 4) * share;
    scene.ambientHigh = linear(5, 5.5f, 8) * share;
    scene.sky = plainSky(linear(1, 1.25f, 2) * share, linear(4, 5.5f, 9) * share);
    scene.fog = 23 / 256.f;
}

Sky duskSky(float row, float late) {
    Rgb low = linear(33, 29, 35), up = linear(4, 10, 28) - low;
    Sky sky = plainSky(low, {});
    sky.slope = up * 3.f, sky.curve = up * -2.2f;
    Vec3 sun = kDuskSun;
    sun.y -= 4 * late;
    sky.sun = normalize(sun);
    float less = 1 - 0.75f * late;
    sky.near = linear(612, 280, 102) * less;
    sky.glow = linear(108, 38, 9) * less;
    sky.clouds = lerp(linear(141, 51, 28), linear(10, 18, 56), late);
    sky.cover = 13 / 32.f;
    sky.drift = row / 256;
    return sky;
}

} // namespace odraz

// Scene 2. Whitted's table: mirror and glass balls circle over a checker of stone and wood.
#include "base/maths.h"
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

namespace {

enum { kBoard, kEdge, kGround, kClear, kSilver, kRed, kStone };
constexpr const Material *kMaterials[] = {
    [kBoard] = &kBoards,  [kEdge] = &kOak,   [kGround] = &kGranite,  [kClear] = &kGlass,
    [kSilver] = &kMirror, [kRed] = &kCopper, [kStone] = &kDarkMarble};

// One of the four that frame the table: mitred enough for the eye, the grain along each side.
constexpr Shape side(int i) {
    float at = i & 1 ? -3.11f : 3.11f;
    bool alongX = i < 2;
    Shape s =
        box(alongX ? Vec3{0, -0.09f, at} : Vec3{at, -0.09f, 0}, {0.11f, 0.13f, alongX ? 3.22f : 3.0f}, kEdge);
    if (alongX) s.frame = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
    s.textureShift = {0.3f, 0.9f + 0.7f * (float)i, 2.0f * (float)i};
    return s;
}
// What stands: the table, the ground, and one great mirror in the middle.
constexpr Shape kShapes[] = {
    box({0, -0.06f, 0}, {3.0f, 0.06f, 3.0f}, kBoard),
    side(0),
    side(1),
    side(2),
    side(3),
    cylinder({0, -1.2f, 0}, 0.8f, 1.05f, kEdge),
    plane({0, -2.2f, 0}, kGround),
    sphere({0, 0.8f, 0}, 0.8f, kSilver),
};
// Five that circle it, two that circle lower the other way, and one above.
constexpr struct {
    float angle, distance, radius, speed, lift;
    int material;
} kMovers[] = {
    {0.3f, 1.75f, 0.46f, 1, 0, kClear}, {1.9f, 1.85f, 0.38f, 1, 0, kRed},
    {3.2f, 1.8f, 0.42f, 1, 0, kStone},  {4.5f, 1.75f, 0.46f, 1, 0, kClear},
    {5.5f, 1.9f, 0.28f, 1, 0, kSilver}, {0.9f, 2.55f, 0.2f, -1, 0, kSilver},
    {4.0f, 2.55f, 0.2f, -1, 0, kEdge},  {2.4f, 0.95f, 0.24f, 2, 1.35f, kClear},
};
constexpr Light kLights[] = {
    {{-4.5f, 5.5f, 3.5f}, {74, 56, 38}, 0.45f},
    {{5.5f, 4.0f, 1.5f}, {10, 13, 19}, 0.8f},
    {{1.0f, 3.5f, -5.5f}, {12, 10, 8}, 0.5f},
};

// A turn of the circle that rests on every beat's end and moves between: one step of an eighth a half bar.
float stepped(double row) {
    double beat = row / 8;
    if (beat < 0) beat = 0;
    int whole = (int)beat;
    float part = (float)(beat - whole);
    return ((float)whole + 0.35f * part + 0.65f * smoothstep(0.f, 1.f, part)) * (kPi / 8);
}

} // namespace

void poseTable(const Cue &cue, Scene &scene) {
    scene.addAll(kMaterials);
    scene.addAll(kShapes);
    scene.addAll(kLights);
    float turn = stepped(cue.row - rowOf(kBallsSetOff));
    for (const auto &m : kMovers) {
        float angle = m.angle + turn * m.speed;
        Vec3 place = {m.distance * cos(angle), m.radius + m.lift, m.distance * sin(angle)};
        Shape *s = scene.add(sphere(place, m.radius, m.material));
        // Roll without slipping: about the radius, by the length of the way over the ball's radius
        float roll = -turn * m.speed * m.distance / m.radius;
        Mat3 outward = {{cos(angle), 0, sin(angle)}, {0, 1, 0}, {-sin(angle), 0, cos(angle)}};
        Mat3 rolled = {{1, 0, 0}, {0, cos(roll), sin(roll)}, {0, -sin(roll), cos(roll)}};
        s->frame = rolled * outward;
        s->textureShift = {m.angle, m.distance, 0.5f};
    }

    scene.contact = true;
    scene.ambientLow = {0.075f, 0.065f, 0.055f};
    scene.ambientHigh = {0.11f, 0.135f, 0.18f};
    // Late light: a glow stands where the key light comes from, and on every ball
    scene.sky = plainSky({0.34f, 0.33f, 0.36f}, {0.030f, 0.070f, 0.17f});
    scene.sky.sun = normalize(Vec3{-4.5f, 2.2f, 3.5f});
    scene.sky.near = {1.1f, 0.62f, 0.30f};
    scene.sky.glow = scene.sky.near * 0.1f;
    scene.fog = 0.02f;
    scene.exposure = 0.9f;
}

} // namespace odraz

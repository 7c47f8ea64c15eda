// Scene 2. Whitted's table: mirror and glass balls circle over a checker of stone and wood, on dark ground
// that mirrors them, in front of a burning sky.
#include "base/maths.h"
#include "show/materials.h"
#include "show/point_of_light.h"
#include "show/scenes.h"

namespace odraz {

namespace {

enum { kBoard, kEdge, kGround, kClear, kSilver, kRed, kStone };
constexpr const Material *kMaterials[] = {
    [kBoard] = &kBoards,  [kEdge] = &kOak,   [kGround] = &kSlate,    [kClear] = &kGlass,
    [kSilver] = &kMirror, [kRed] = &kCopper, [kStone] = &kDarkMarble};

// One of the four sides of the table's frame. Corners look mitred, and the grain runs along each side.
constexpr Shape side(int i) {
    float at = i & 1 ? -3.11f : 3.11f;
    bool alongX = i < 2;
    Shape s =
        box(alongX ? Vec3{0, -0.09f, at} : Vec3{at, -0.09f, 0}, {0.11f, 0.13f, alongX ? 3.22f : 3.0f}, kEdge);
    if (alongX) s.frame = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
    s.textureShift = {0.15f, 0.9f + 0.7f * (float)i, 2.0f * (float)i};
    return s;
}
// Shapes that do not move: the table, the ground, and a large mirror ball in the middle.
constexpr Shape kShapes[] = {
    box({0, -0.06f, 0}, {3.0f, 0.06f, 3.0f}, kBoard),
    side(0),
    side(1),
    side(2),
    side(3),
    plane({0, -0.22f, 0}, kGround),
    sphere({0, 0.8f, 0}, 0.8f, kSilver),
};
// Balls in the order in which they start, a beat apart: five that circle the mirror ball, the foremost first,
// so that none meets another; three further out, the last of which passes the lens at the end; and one above.
constexpr struct {
    float angle, distance, radius, speed, lift;
    int material;
} kMovers[] = {
    {5.02f, 1.5f, 0.40f, 1, 0, kClear},      {3.76f, 1.5f, 0.30f, 1, 0, kEdge},
    {2.50f, 1.5f, 0.38f, 1, 0, kRed},        {1.24f, 1.5f, 0.42f, 1, 0, kClear},
    {-0.02f, 1.5f, 0.38f, 1, 0, kRed},       {5.75f, 2.35f, 0.22f, 1, 0, kStone},
    {3.65f, 2.35f, 0.2f, 1, 0, kSilver},     {1.55f, 2.35f, 0.3f, 1, 0, kClear},
    {2.4f, 0.95f, 0.24f, -1, 1.35f, kClear},
};
constexpr float kBeat = 4, kSpeed = 0.03f;                                  // rows; radians per row
constexpr float kMacroFrom = rowOf(kMacro), kMacroTo = rowOf(kCopperFills); // a close-up of glass balls
// The sun; then a higher sun for the second shot, which the balls focus on the board
constexpr Light kKeyLights[] = {
    {kDuskSun, {620, 390, 210}, 0.6f},
    {{-13.7f, 10.5f, 10.6f}, {620, 390, 210}, 0.6f},
};

} // namespace

void poseTable(const SceneInput &in, Scene &scene) {
    scene.addAll(kMaterials);
    scene.materials[kStone].reflect = 0.2f;
    scene.addAll(kShapes);
    scene.add(kKeyLights[in.row >= kMacroFrom && in.row < kMacroTo]);
    PointOfLight point = pointOf(kTable, in.row);
    addPoint(scene, point, min(0.0075f + 0.11f * point.shine, 0.035f), {1.6f, 1.1f, 0.6f});
    float rows = in.row - rowOf(kBallsSetOff);
    for (const auto &m : kMovers) {
        // Start from rest and reach full speed within a beat
        float speeds = clamp(rows, 0.f, kBeat),
              turn = (speeds * speeds * (0.5f / kBeat) + max(rows - kBeat, 0.f)) * kSpeed;
        rows -= kBeat;
        float angle = m.angle + turn * m.speed;
        Vec3 centre = {m.distance * cos(angle), m.radius + m.lift, m.distance * sin(angle)};
        Shape *s = scene.add(sphere(centre, m.radius, m.material));
        // Roll without slipping: the angle is the length of the path divided by the radius
        float roll = -turn * m.speed * m.distance / m.radius;
        Mat3 outward = {{cos(angle), 0, sin(angle)}, {0, 1, 0}, {-sin(angle), 0, cos(angle)}};
        Mat3 rolled = {{1, 0, 0}, {0, cos(roll), sin(roll)}, {0, -sin(roll), cos(roll)}};
        s->frame = rolled * outward;
        s->textureShift = {m.angle, m.distance, 0.5f};
    }

    scene.ballsOcclude = true;
    scene.ambientLow = {0.06f, 0.045f, 0.045f};
    scene.ambientHigh = {0.12f, 0.17f, 0.28f};
    scene.sky = duskSky(in.row);
    if (in.row < kMacroFrom) scene.sky.cloudScale = 0.5f; // clouds fill half of the first shot's picture
    scene.exposure = in.row >= kMacroTo && in.row < rowOf(kDarkBall) ? 0.7f : 0.88f; // copper is bright
}

} // namespace odraz

// The stretch between the table and the credits: a court of columns at nightfall, its lamps, and balls that
// roll down its aisle. It holds the place of the flake and of the hall until these are built.
#include "base/maths.h"
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

using enum Interpolation;

static constexpr Key kDusk[] = {{0, 1, Smooth}, {192, 0.75f, Smooth}, {576, 0.2f, Smooth}, {688, 0, Linear}};
static constexpr Key kLamps[] = {{40, 0, Smooth},      {120, 0.7f, Linear}, {384, 0.8f, Smooth},
                                 {520, 1.15f, Linear}, {690, 1, Smooth},    {840, 0.12f, Linear}};
static constexpr Key kRolling[] = {{0, 0, Linear}, {848, 26, Linear}}; // metres rolled

static constexpr int kPairs = 4;
static constexpr float kSpacing = 3.1f, kAside = 2.2f, kFirst = 4.9f;

static void addColumn(Scene &scene, Vec3 foot, int shaft, int block) {
    scene.add(box(foot + Vec3{0, 0.12f, 0}, {0.42f, 0.12f, 0.42f}, block));
    Shape *s = scene.add(cylinder(foot + Vec3{0, 1.79f, 0}, 0.27f, 1.55f, shaft));
    s->textureShift = {foot.x * 1.7f, 0, foot.z * 2.3f};
    scene.add(box(foot + Vec3{0, 3.44f, 0}, {0.38f, 0.1f, 0.38f}, block));
}

void poseCourt(double row, Hall *, Scene &scene) {
    float dusk = value(track(kDusk), row), lamps = value(track(kLamps), row);
    int floor = scene.add(polishedFloor()), shaft = scene.add(paleMarble()), block = scene.add(granite());
    int beam = scene.add(oak()), silver = scene.add(mirror()), clear = scene.add(glass()),
        red = scene.add(copper());
    int glow = scene.add(lamp(Rgb{3.0f, 2.3f, 1.4f} * lamps));

    // Floor, columns in pairs, beams along and across, a wall with a round opening at the end
    scene.add(plane({0, 0, 0}, floor));
    for (int i = 0; i < kPairs; ++i) {
        float z = kFirst - kSpacing * (float)i;
        for (int side = -1; side <= 1; side += 2)
            addColumn(scene, {kAside * (float)side, 0, z}, shaft, block);
        Shape *s = scene.add(box({0, 3.86f, z}, {0.13f, 0.14f, 2.9f}, beam));
        s->frame = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
        s->textureShift = {0.8f, 0.4f, 3.1f * (float)i};
    }
    for (int side = -1; side <= 1; side += 2)
        scene.add(box({kAside * (float)side, 3.63f, 0.8f}, {0.17f, 0.09f, 6.1f}, beam))->textureShift = {
            0.2f, 1.1f, (float)side};
    float outline[2 * 44];
    int points = 0;
    auto point = [&](float x, float y) {
        outline[2 * points] = x;
        outline[2 * points++ + 1] = y;
    };
    // Around the wall, and by a slit from below around the opening
    static constexpr float kWall = 3.4f, kHigh = 4.4f, kEye = 2.25f, kOpening = 1.15f;
    point(-kWall, 0), point(-kWall, kHigh), point(kWall, kHigh), point(kWall, 0), point(0, 0);
    for (int i = 0; i <= 32; ++i) {
        float a = (float)i * (kPi / 16);
        point(kOpening * sin(a), kEye - kOpening * cos(a));
    }
    point(0, 0);
    Mat3 upright = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}; // local z is up, the normal looks down the aisle
    scene.addPolygon({0, 0, -6.2f}, upright, outline, points, block);

    // Lamps hang between the columns; the last one before the wall shines all around, the others throw cones
    for (int i = 0; i < 3; ++i) {
        float z = kFirst - kSpacing * ((float)i + 0.5f);
        scene.add(sphere({0, 3.05f, z}, 0.09f, glow));
        Light spot = {{0, 3.05f, z}, Rgb{13, 9.2f, 5.6f} * lamps, {0, -1, 0}, 0.3f, 0.85f};
        scene.add(i < 2 ? spot : pointLight(spot.position, Rgb{9, 6.4f, 3.8f} * lamps));
    }
    // What is left of the day comes from the left and through the round opening
    scene.add(pointLight({-16, 13, -7}, Rgb{190, 150, 130} * dusk));
    scene.add(pointLight({2.5f, 4.5f, -16}, Rgb{40, 60, 95} * (0.3f + 0.7f * dusk)));

    // The balls: one rests in the middle, the others roll on around it
    scene.add(sphere({0, 0.75f, 0}, 0.75f, silver));
    float rolled = value(track(kRolling), row);
    struct Roller {
        float x, z, radius, speed; // where it starts, and the share of the way it goes down the aisle
        int material;
    } rollers[] = {
        {-1.2f, 4.4f, 0.34f, 0.30f, red},    {1.25f, 3.0f, 0.42f, -0.22f, clear},
        {1.15f, -3.4f, 0.3f, -0.09f, red},   {-1.3f, -3.0f, 0.45f, -0.05f, clear},
        {0.3f, -5.2f, 0.36f, 0.02f, silver},
    };
    for (const Roller &r : rollers) {
        float way = rolled * r.speed, turn = way / r.radius;
        Shape *s = scene.add(sphere({r.x, r.radius, r.z + way}, r.radius, r.material));
        s->frame = {{1, 0, 0}, {0, cos(turn), sin(turn)}, {0, -sin(turn), cos(turn)}};
    }

    scene.sky = plainSky(Rgb{0.62f, 0.38f, 0.27f} * dusk + Rgb{0.02f, 0.028f, 0.045f},
                         Rgb{0.07f, 0.11f, 0.22f} * dusk + Rgb{0.004f, 0.007f, 0.016f});
    scene.contact = true;
    scene.ambientLow = Rgb{0.12f, 0.085f, 0.07f} * dusk + Rgb{0.035f, 0.026f, 0.018f} * lamps;
    scene.ambientHigh = Rgb{0.17f, 0.17f, 0.23f} * dusk + Rgb{0.02f, 0.017f, 0.016f} * lamps;
    scene.fog = 0.02f;
    scene.exposure = 1.05f;
}

} // namespace odraz

#include "show/hall_model.h"

#include "base/maths.h"

namespace odraz {

namespace {

constexpr float kDoor = 1.75f, kDoorHeight = 3; // half the door's width; the door's height
constexpr float kBeam = 0.15f;                  // half a beam's width
constexpr float kLanternY = 4.0f, kLanternZ[kLanterns] = {-kLanternSpacing, 0, kLanternSpacing};

void addColumn(Model &m, float x, float z) {
    m.addBox({x - 0.42f, 0, z - 0.42f}, {x + 0.42f, 0.32f, z + 0.42f}, kBlock, 0.29f,
             Model::kUpright | Model::kTop);
    constexpr float kLow = 0.32f, kHigh = 5.15f, kRadius = kColumnRadius;
    for (int k = 0; k < 8; ++k) {
        auto corner = [&](int i) {
            float a = ((float)i + 0.5f) * (kPi / 4);
            return Vec3{x + kRadius * cos(a), kLow, z - kRadius * sin(a)};
        };
        Vec3 a = corner(k), b = corner(k + 1);
        m.addRect(a, b - a, {0, kHigh - kLow, 0}, kShaft, 0.46f);
    }
    m.addBox({x - 0.38f, kHigh, z - 0.38f}, {x + 0.38f, 5.45f, z + 0.38f}, kBlock, 0.29f,
             Model::kUpright | Model::kBottom | Model::kTop);
}

void addStair(Model &m) {
    constexpr float kLeft = 2.9f, kRise = 0.2f, kTread = 0.34f, kStart = -3.4f;
    constexpr int kSteps = 8;
    for (int i = 0; i < kSteps; ++i) {
        float z0 = kStart - kTread * (float)i, z1 = i + 1 < kSteps ? z0 - kTread : -kZ;
        Vec3 hi = {kX, kRise * (float)(i + 1), z0};
        m.addBox({kLeft, hi.y - kRise, z1}, hi, kStep, 0.38f, Model::kFront | Model::kTop);
        m.addBox({kLeft, 0, z1}, hi, kStep, 0.38f, Model::kLeft);
    }
}

void build(Hall &hall) {
    Model &m = hall.model;
    Vec3 x = {2 * kX, 0, 0}, y = {0, kY, 0}, z = {0, 0, 2 * kZ};
    hall.floor = m.addRect({-kX, 0, -kZ}, z, x, kFloor, 0.42f);
    // The ceiling has a chart for each bay, because beams separate the light of the bays
    for (int i = 0; i < 5; ++i) {
        float from = i ? kColumns[i - 1] + kBeam : -kZ, to = i < 4 ? kColumns[i] - kBeam : kZ;
        int bay = m.addRect({-kX, kY, from}, x, {0, 0, to - from}, kBeamX, 0.62f);
        if (i == 2) hall.vault = bay;
    }
    m.addRect({kX, 0, -kZ}, z, y, kWarm, 0.52f);
    // The wall with the entrance
    m.addRect({kX, 0, kZ}, -x, y, kWall, 0.52f, Model::kPieces);
    m.addFacet(0, 0, kX - kDoor, kY);
    m.addFacet(kX + kDoor, 0, 2 * kX, kY);
    m.addFacet(kX - kDoor, kDoorHeight, kX + kDoor, kY);
    m.addRect({kDoor, 0, kZ}, {-2 * kDoor, 0, 0}, {0, kDoorHeight, 0}, kWall, 1.39f, Model::kOpen);
    m.addRect({-kX, 0, -kZ}, x, y, kWall, 0.52f);
    // The wall with the windows, in pieces, and the sides of the openings
    m.addRect({-kX, 0, kZ}, -z, y, kWall, 0.42f, Model::kPieces);
    m.addFacet(0, 0, 2 * kZ, kSill);
    m.addFacet(0, kLintel, 2 * kZ, kY);
    float from = 0;
    for (int i = 4; i >= 0; --i) {
        m.addFacet(from, kSill, kZ - kWindows[i] - kWindow, kLintel);
        from = kZ - kWindows[i] + kWindow;
    }
    m.addFacet(from, kSill, 2 * kZ, kLintel);
    for (float centre : kWindows) {
        Vec3 lo = {-kX - kDeep, kSill, centre - kWindow}, deep = {kDeep, 0, 0},
             tall = {0, kLintel - kSill, 0};
        Vec3 wide = {0, 0, 2 * kWindow};
        // The steepest indirect light is here, where lit surfaces meet: with cells of 0.2 m the error at noon
        // is 12 % instead of 8
        m.addRect(lo, wide, deep, kWall, 0.14f);        // sill
        m.addRect(lo + tall, deep, wide, kWall, 0.14f); // lintel
        m.addRect(lo, deep, tall, kWall, 0.14f);        // jambs
        m.addRect(lo + wide + deep, -deep, tall, kWall, 0.14f);
        m.addRect(lo + wide, -wide, tall, kWall, 0.6f, Model::kOpen);
    }
    for (int side = -1; side <= 1; side += 2) {
        float cx = kColumnX * (float)side;
        for (float cz : kColumns) addColumn(m, cx, cz);
        m.addBox({cx - 0.2f, 5.45f, -kZ}, {cx + 0.2f, 5.85f, kZ}, kBeamZ, 0.62f,
                 Model::kLeft | Model::kRight | Model::kBottom | Model::kTop);
    }
    for (float cz : kColumns)
        m.addBox({-kX, 5.85f, cz - kBeam}, {kX, kY, cz + kBeam}, kBeamX, 0.62f,
                 Model::kFront | Model::kBack | Model::kBottom);
    addStair(m);
}

void addLamps(Hall &hall) {
    Lamp *lamp = hall.radiosity.bases.lamps; // the lanterns, then the strips
    for (float cz : kLanternZ) *lamp++ = {{0, kLanternY, cz}, kLanternRadius, -1};
    for (int i = 0; i < kStrips; ++i) {
        Vec3 corner = {((float)i - 3.5f) * 0.4f - 0.14f, 0.3f, 0.005f - kZ};
        int chart = hall.model.addRect(corner, {0.28f, 0, 0}, {0, 3.9f, 0}, kStrip + i, 1.04f);
        *lamp++ = {{}, 0, chart};
    }
}

} // namespace

void buildHall(Hall &hall) {
    build(hall);
    addLamps(hall);
    // The sizes above are for patches, which are two cells wide and high: double the numbers of cells
    for (int i = 0; i < hall.model.chartCount; ++i)
        hall.model.charts[i].across *= 2, hall.model.charts[i].down *= 2;
}

} // namespace odraz

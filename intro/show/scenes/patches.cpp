// Scene 4. The hall, before light: its patches, flat and grey; one is visited, and what it sees opens as five
// small pictures; it takes its colour, then all of them do, wave and bounce by bounce; we walk in, and
// patches become surfaces. Everything shown is the solver's: the patches, the hemicube, the light after each
// bounce.
#include "base/maths.h"
#include "show/show.h"
#include "trace/picture/overlay.h"

namespace odraz {

using enum Interpolation;

static constexpr float kGrey = 0.6f; // albedo of everything, at first
static constexpr Key kOpen[] = {{rowOf(kHalfCubeOpens), 0, Smooth},
                                {rowOf(kHalfCubeOpens) + 12, 1, Linear},
                                {rowOf(kHalfCubeCloses), 1, Smooth},
                                {rowOf(kHalfCubeCloses) + 6, 0, Linear}};
static constexpr Key kTaken[] = {{rowOf(kPatchTakesColour), 0, Smooth},
                                 {rowOf(kPatchTakesColour) + 6, 1, Linear}};
static constexpr Key kBounce[] = {{rowOf(kBounce1), 0, Smooth}, {rowOf(kBounce1) + 1.5f, 1, Linear},
                                  {rowOf(kBounce2), 1, Smooth}, {rowOf(kBounce2) + 1.5f, 2, Linear},
                                  {rowOf(kBounce3), 2, Smooth}, {rowOf(kBounce3) + 1.5f, 3, Linear},
                                  {rowOf(kBounce4), 3, Smooth}, {rowOf(kBounce4) + 2, 4, Linear}};
static constexpr Key kExposure[] = {{rowOf(kColoursSpread), 1.5f, Smooth},
                                    {rowOf(kBounce1), 1.9f, Linear},
                                    {140, 1.9f, Smooth},
                                    {180, 1.7f, Linear}};
static constexpr Key kMelt[] = {{rowOf(kPatchesMelt), 0, Smooth}, {rowOf(kPatchesMelt) + 32, 1, Linear}};
static constexpr Key kReal[] = {{rowOf(kPatchesMelt) + 6, 0, Smooth}, {rowOf(kPatchesMelt) + 38, 1, Linear}};

// What a patch shows: grey by the way it faces, in the end its light after so many bounces.
static Rgb patchLight(const Hall &hall, int i, float bounces, float lit) {
    const Model &m = hall.model;
    const Chart &c = m.charts[m.patches[i].chart];
    Rgb grey = Rgb{1, 1, 1.06f} * (0.13f + 0.075f * c.n.y + 0.05f * c.n.x - 0.025f * c.n.z);
    if (lit <= 0) return grey;
    if (m.patches[i].share == 0) return grey * (1 - 0.88f * lit); // under the stair there is no light
    int whole = min((int)bounces, kBounces - 1);
    return lerp(grey, lerp(hall.bounce[whole][i], hall.bounce[whole + 1][i], bounces - (float)whole), lit);
}

void posePatches(const Cue &cue, Scene &scene) {
    double row = cue.row;
    Hall *hall = cue.hall;
    float melt = value(track(kMelt), row), real = value(track(kReal), row),
          bounces = value(track(kBounce), row);
    HallLight light = {kNoon, {}, {}, real};
    poseHall(*hall, light, 1 - real, cue.camera.eye, scene);
    if (row < 128) scene.sky = plainSky({0.012f, 0.013f, 0.016f}, {0.03f, 0.034f, 0.045f});
    scene.exposure = value(track(kExposure), row);
    scene.lines = 0.75f * (1 - melt);
    hall->map.sharpness = exp2((1 - melt) * 10);
    hall->map.mosaic = 1 - melt;
    if (melt == 1) return;

    // The patches' light, as it has spread from the visited one
    const Model &m = hall->model;
    Vec3 from = m.patches[hall->visited].p;
    float reach = ((float)row - rowOf(kColoursSpread)) * 1.25f;
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        float lit = saturate((reach - length(p.p - from)) * 0.5f);
        if (i == hall->visited) lit = max(lit, value(track(kTaken), row));
        Rgb own = patchLight(*hall, i, i == hall->visited ? max(bounces, 1.f) : bounces, lit);
        // What its own reflectance makes of the light, until surfaces have that themselves
        own = own * lerp(Rgb{1, 1, 1}, lerp(hall->mean[c.material] * (1 / kGrey), Rgb{1, 1, 1}, real), lit);
        if (i == hall->visited && row > rowOf(kPatchIsVisited) && row < rowOf(kHalfCubeCloses) - 2) {
            float pulse = 0.5f - 0.5f * cos(((float)row - rowOf(kPatchIsVisited)) * (kPi / 4));
            own = lerp(own, Rgb{1.3f, 0.55f, 0.26f},
                       row < rowOf(kHalfCubeOpens) ? pulse : 1 - value(track(kTaken), row));
        }
        hall->mosaic[0][i] = own.x, hall->mosaic[1][i] = own.y, hall->mosaic[2][i] = own.z;
    }
}

void letterPatches(const Cue &cue, const View &view, Frame &frame) {
    const Hall *hall = cue.hall;
    float open = value(track(kOpen), cue.row);
    if (open == 0) return;
    // From the patch it grows to its place
    float h = (float)frame.height, size = h * 0.14f * open; // half a face
    float px, py;
    view.project(hall->model.patches[hall->visited].p, px, py);
    float x0 = lerp(px, view.width - h * 0.33f, open), y0 = lerp(py, h * 0.6f, open);
    Stroke line = {px, py, lerp(px, x0, open), lerp(py, y0, open)};
    drawStrokes(frame, &line, 1, h * 0.0012f, {0.8f, 0.35f, 0.17f}, 0.8f * open);

    const Model &m = hall->model;
    constexpr int side = kSeen;
    float flap = smoothstep(0.35f, 1.f, open); // how far the sides have folded out
    float limit = (1 + flap) * size;
    for (int y = max((int)(y0 - limit), 0); y < min((int)(y0 + limit), frame.height); ++y)
        for (int x = max((int)(x0 - limit), 0); x < min((int)(x0 + limit), frame.width); ++x) {
            // Which face, and where on it: the unfolded cross
            float u = ((float)x + 0.5f - x0) / size, v = ((float)y + 0.5f - y0) / size;
            bool aside = abs(u) > 1, below = abs(v) > 1;
            if (aside && below) continue;
            int column, line;
            if (!aside && !below) {
                column = (int)((u + 1) * 0.5f * (float)side);
                line = (int)((v + 1) * 0.5f * (float)side);
            } else {
                float up = 1 - ((aside ? abs(u) : abs(v)) - 1) / flap;
                if (!(up > 0)) continue;
                int face = aside ? (u > 0 ? 0 : 2) : (v > 0 ? 1 : 3);
                float along = face == 0 ? v : face == 1 ? -u : face == 2 ? -v : u;
                column = (int)((along + 1) * 0.5f * (float)side);
                line = side + face * (side / 2) + (int)(up * (float)(side / 2));
            }
            uint32_t id = hall->seen[min(line, 3 * side - 1) * side + min(column, side - 1)];
            Rgb colour = {};
            if (id != kNothing && id != kBackSide) {
                const Chart &c = m.charts[m.patches[id - 1].chart];
                colour =
                    c.open ? Rgb{0.8f, 0.9f, 1.05f} : hall->bounce[0][id - 1] * hall->mean[c.material] * 6.f;
            }
            size_t at = (size_t)y * (size_t)frame.stride + (size_t)x;
            frame.plane[0][at] = colour.x, frame.plane[1][at] = colour.y, frame.plane[2][at] = colour.z;
        }
}

} // namespace odraz

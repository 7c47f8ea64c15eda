// Scene 4. The hall, before light: its patches, flat and nearly black; one is visited, its half-cube rises
// over it and unfolds into five pictures of what it sees, the hall as it is then; it takes its colour. Then
// there is light for all, and bounce by bounce what each adds: in copper, brightened so that it can be seen,
// before it joins the rest. We walk in, and patches become surfaces. Everything shown is the solver's: the
// patches, the hemicube, the light after each bounce.
#include "base/maths.h"
#include "show/font.h"
#include "show/show.h"
#include "trace/picture/overlay.h"

namespace odraz {

using enum Interpolation;

static constexpr float kGrey = 0.6f; // albedo of everything, at first
static constexpr Key kRise[] = {{rowOf(kHalfCubeRises), 0, Smooth}, {rowOf(kHalfCubeRises) + 12, 1, Linear}};
static constexpr Key kOpen[] = {{rowOf(kHalfCubeOpens), 0, Smooth},
                                {rowOf(kHalfCubeOpens) + 12, 1, Linear},
                                {rowOf(kHalfCubeCloses), 1, Smooth},
                                {rowOf(kHalfCubeCloses) + 8, 0, Linear}};
static constexpr Key kTaken[] = {{rowOf(kPatchTakesColour), 0, Smooth},
                                 {rowOf(kPatchTakesColour) + 6, 1, Linear}};
static constexpr Key kExposure[] = {{rowOf(kPatchesMelt), 1.9f, Smooth},
                                    {rowOf(kPatchesMelt) + 44, 1.7f, Linear}};
static constexpr Key kMelt[] = {{rowOf(kPatchesMelt) + 2, 0, Smooth}, {rowOf(kPatchesMelt) + 30, 1, Linear}};
static constexpr Key kReal[] = {{rowOf(kPatchesMelt) + 8, 0, Smooth}, {rowOf(kPatchesMelt) + 36, 1, Linear}};

// What light adds at each step, and how much brighter than it is it shows.
static constexpr int kStages = 4;
static constexpr float kGain[kStages] = {1, 2, 6, 15};
static constexpr float kRows[kStages] = {rowOf(kDirectLight), rowOf(kBounce1), rowOf(kBounce2),
                                         rowOf(kBounce3)};
static constexpr Rgb kCopperLight = {1.9f, 0.86f, 0.42f};

// How far a step has come: what it adds rises and, before its bar ends, joins the rest.
struct Step {
    int number; // -1: there is no light yet
    float rise, join;

    explicit Step(double row) {
        number = -1;
        while (number + 1 < kStages && (float)row >= kRows[number + 1]) ++number;
        float at = (float)row - kRows[max(number, 0)];
        rise = smoothstep(0.f, 3.f, at);
        join = smoothstep(10.f, 15.f, at);
    }
    Rgb of(const Hall &hall, int patch) const {
        Rgb before = number ? hall.bounce[number - 1][patch] : Rgb{},
            more = hall.bounce[number][patch] - before;
        Rgb shows = lerp(number ? kCopperLight : Rgb{1, 1, 1}, Rgb{1, 1, 1}, join);
        return before * lerp(1 - 0.7f * rise * min((float)number, 1.f), 1.f, join) +
               more * shows * (rise * lerp(kGain[number], 1.f, join));
    }
};

// What a patch shows: nearly nothing, by the way it faces, and then light.
static Rgb patchLight(const Hall &hall, int i, const Step &step, float lit) {
    const Model &m = hall.model;
    const Chart &c = m.charts[m.patches[i].chart];
    Rgb grey = Rgb{1, 1, 1.12f} * (0.055f + 0.034f * c.n.y + 0.02f * c.n.x - 0.012f * c.n.z);
    if (lit <= 0 || step.number < 0) return grey;
    if (m.patches[i].share == 0) return grey * (1 - 0.8f * lit); // under the stair there is no light
    return lerp(grey, step.of(hall, i), lit);
}

void posePatches(const Cue &cue, Scene &scene) {
    double row = cue.row;
    Hall *hall = cue.hall;
    float melt = value(track(kMelt), row), real = value(track(kReal), row);
    Step step(row);
    HallLight light = {kNoon, {}, {}, real};
    poseHall(*hall, light, 1 - real, cue.camera.eye, scene);
    if (row < rowOf(kPatchesMelt)) scene.sky = plainSky({0.012f, 0.013f, 0.016f}, {0.03f, 0.034f, 0.045f});
    scene.exposure = value(track(kExposure), row);
    scene.lines = 0.75f * (1 - melt);
    hall->map.sharpness = exp2((1 - melt) * 10);
    hall->map.mosaic = 1 - melt;
    if (melt == 1) return;

    // The patches' light, as it has spread from the visited one
    const Model &m = hall->model;
    Vec3 from = m.patches[hall->visited].p;
    float reach = ((float)row - rowOf(kDirectLight)) * 3;
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        float lit = saturate((reach - length(p.p - from)) * 0.5f);
        Rgb own = patchLight(*hall, i, step, lit);
        if (i == hall->visited && step.number < 0)
            own = lerp(own, hall->bounce[1][i] * 2.f, value(track(kTaken), row));
        // What its own reflectance makes of the light, until surfaces have that themselves
        own = own * lerp(Rgb{1, 1, 1}, lerp(hall->mean[c.material] * (1 / kGrey), Rgb{1, 1, 1}, real), lit);
        if (i == hall->visited && row > rowOf(kPatchIsVisited) && row < rowOf(kHalfCubeCloses) - 2) {
            float pulse = 0.5f - 0.5f * cos(((float)row - rowOf(kPatchIsVisited)) * (kPi / 4));
            own = lerp(own, Rgb{1.3f, 0.55f, 0.26f},
                       row < rowOf(kHalfCubeRises) ? pulse : 1 - value(track(kTaken), row));
        }
        hall->mosaic[0][i] = own.x, hall->mosaic[1][i] = own.y, hall->mosaic[2][i] = own.z;
    }
}

// The half-cube's edges over its patch, `size` wide to every side.
static void drawHalfCube(const Patch &patch, const Chart &chart, float size, const View &view, Frame &frame,
                         float opacity) {
    Vec3 corner[8];
    Vec3 u = chart.u * size, v = chart.v * size;
    for (int i = 0; i < 8; ++i)
        corner[i] =
            patch.p + u * (i & 1 ? 1.f : -1.f) + v * (i & 2 ? 1.f : -1.f) + chart.n * (i & 4 ? size : 0.f);
    Stroke edges[12];
    int count = 0;
    for (int i = 0; i < 8; ++i)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit)) {
                Stroke &s = edges[count++];
                view.project(corner[i], s.x0, s.y0);
                view.project(corner[i | bit], s.x1, s.y1);
            }
    drawStrokes(frame, edges, count, (float)frame.height * 0.0016f, Rgb{1.6f, 0.7f, 0.34f}, opacity);
}

void letterPatches(const Cue &cue, const View &view, Frame &frame) {
    const Hall *hall = cue.hall;
    Step step(cue.row);
    float h = (float)frame.height;
    if (step.number >= 0 && cue.row < rowOf(kPatchesMelt)) {
        static constexpr char kNames[kStages][16] = {"direct light", "bounce 1", "bounce 2", "bounce 3"};
        drawText(frame, kNames[step.number], h * 0.12f, h * 0.88f, h * 0.032f, 0.085f, 1.6f, Align::Left,
                 {0.8f, 0.42f, 0.24f}, step.rise);
    }
    const Patch &visited = hall->model.patches[hall->visited];
    float open = value(track(kOpen), cue.row), rise = value(track(kRise), cue.row);
    if (rise > 0 && cue.row < rowOf(kHalfCubeCloses) + 8)
        drawHalfCube(visited, hall->model.charts[visited.chart], 1.5f * rise, view, frame, rise);
    if (open == 0) return;
    // From the patch it grows to its place
    float size = h * 0.14f * open; // half a face
    float px, py;
    view.project(visited.p, px, py);
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
                colour = c.open
                             ? Rgb{0.8f, 0.9f, 1.05f}
                             : Rgb{hall->mosaic[0][id - 1], hall->mosaic[1][id - 1], hall->mosaic[2][id - 1]};
            }
            size_t at = (size_t)y * (size_t)frame.stride + (size_t)x;
            frame.plane[0][at] = colour.x, frame.plane[1][at] = colour.y, frame.plane[2][at] = colour.z;
        }
}

} // namespace odraz

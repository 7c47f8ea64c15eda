// Scene 4. The hall before light: its patches, black with copper lines. One is visited: its hemicube rises
// over it and unfolds into five pictures of what it sees, and the patch takes its colour. Then a wave of
// direct light runs over all patches, then bounce after bounce. The light that a bounce adds is shown
// brightened, in a colour of its own (amber, rose, blue), before it joins the rest. The camera goes in, and
// patches become surfaces. All data are the solver's: patches, hemicube, light after each bounce.
#include "base/maths.h"
#include "show/font.h"
#include "show/hemicube_view.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/patches.keys"

static constexpr float kGrey = 0.6f; // albedo of all surfaces at first

// The stages of light, direct light and then bounces: the row on which each begins, and the factor by which
// its contribution is brightened, by colour.
static constexpr struct {
    float row;
    Rgb gain;
    char name[16];
} kStages[] = {
    {rowOf(kDirectLight) - 0.6f, {1, 1, 1}, "direct light"},
    {rowOf(kBounce1), {4.4f, 2.2f, 0.7f}, "bounce 1"},
    {rowOf(kBounce2), {6.6f, 3, 4.2f}, "bounce 2"},
    {rowOf(kBounce3), {2, 8, 26}, "bounce 3"},
};
static constexpr int kStageCount = sizeof kStages / sizeof *kStages;
static_assert(kStageCount <= kBounces + 1);
static constexpr float kWave = 30; // metres per row: light reaches all patches by the row of the hit
static constexpr Rgb kCopperLight = {1.9f, 0.86f, 0.42f}, kDarkCopper = {2.6f, 1.6f, 1.25f},
                     kSunlight = {1.2f, 0.8f, 0.5f};
// The path of a photon from the sun: through a window, to floor, wall and column
static constexpr Vec3 kPhoton[] = {
    {-7.5f, 6.3f, 3.3f}, {-1.2f, 0, 3.3f}, {1.5f, 3, -9}, {-1.93f, 2.2f, -1.7f}};

// The stage of light at a row. Its contribution appears on its row and joins the rest before its bar ends.
struct LightStage {
    int number; // index in kStages; -1: no light yet
    float join;

    explicit LightStage(float row) {
        number = -1;
        while (number + 1 < kStageCount && row >= kStages[number + 1].row) ++number;
        float at = row - kStages[max(number, 0)].row;
        join = smoothstep(8.f, 10.5f, at);
    }
    Rgb light(const Hall &hall, int patch) const {
        Rgb before = number ? hall.bounce[number - 1][patch] : Rgb{},
            more = hall.bounce[number][patch] - before;
        return before * lerp(number ? 0.3f : 1, 1.f, join) +
               more * lerp(kStages[number].gain, Rgb{1, 1, 1}, join);
    }
};

// Returns a patch's colour: a dark copper that depends on its normal, and later its light.
static Rgb patchLight(const Hall &hall, int i, const LightStage &stage, float lit) {
    const Model &m = hall.model;
    const Vec3 n = m.charts[m.patches[i].chart].n;
    Rgb dark = kDarkCopper * (0.006f + 0.0033f * n.y + 0.0024f * n.x - 0.0013f * n.z);
    // Patches under the stair get no light
    return stage.number < 0 || m.patches[i].share == 0 ? dark : dark * (1 - lit) + stage.light(hall, i) * lit;
}

void posePatches(const SceneInput &in, Scene &scene) {
    float row = in.row;
    Hall *hall = in.hall;
    float melt = value(track(kMelt), row), real = value(track(kReal), row);
    LightStage stage(row);
    HallLight light = {kNoon, {}, {}, real};
    poseHall(*hall, light, 1 - real, in.camera.eye, scene);
    if (row < rowOf(kPatchesMelt)) scene.sky = plainSky({0.003f, 0.003f, 0.004f}, {0.003f, 0.003f, 0.004f});
    scene.exposure = value(track(kExposure), row);
    scene.lines = value(track(kLines), row) * (1 - melt);
    hall->map.sharpness = exp2((1 - melt) * 10);
    hall->map.mosaic = 1 - melt;
    if (melt == 1) return;

    // Colour the patches. Light spreads from the visited one
    const Model &m = hall->model;
    Vec3 from = m.patches[hall->visited].p;
    float reach = (row - kStages[0].row) * kWave;
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        float lit = saturate((reach - length(p.p - from)) * 0.3f);
        Rgb own = patchLight(*hall, i, stage, lit);
        if (i == hall->visited && stage.number < 0)
            own = lerp(own, hall->bounce[1][i], value(track(kTaken), row));
        // Use the patch's own reflectance instead of the common grey's, until its own material is shown
        own = own * lerp(Rgb{1, 1, 1}, lerp(hall->mean[c.material] * (1 / kGrey), Rgb{1, 1, 1}, real), lit);
        if (i == hall->visited && row > rowOf(kPatchIsVisited) && row < rowOf(kDirectLight)) {
            float pulse = 0.5f - 0.5f * cos((row - rowOf(kPatchIsVisited)) * (kPi / 4));
            own = lerp(own, kCopperLight * 0.45f,
                       row < rowOf(kHemicubeRises) ? pulse : 1 - value(track(kTaken), row));
        }
        hall->mosaic[0][i] = own.x, hall->mosaic[1][i] = own.y, hall->mosaic[2][i] = own.z;
    }
}

void letterPatches(const SceneInput &in, const View &view, Frame &frame) {
    const Hall &hall = *in.hall;
    LightStage stage(in.row);
    float h = (float)frame.height;
    if (stage.number >= 0 && in.row < rowOf(kBounce3) + 10)
        drawText(frame, kStages[stage.number].name, view.width - h * 0.12f, h * 0.88f,
                 {h * 0.032f, 0.085f, Align::Right, {0.8f, 0.42f, 0.24f}});
    // Draw a photon: a leg of its path each beat, then into the lens
    float flown = in.row < rowOf(kPatchesMelt) ? (in.row - rowOf(kBounce3)) / 4 : 0;
    for (int i = 0; i < 3 && flown > (float)i; ++i) {
        Stroke leg;
        view.project(kPhoton[i], leg.x0, leg.y0);
        view.project(lerp(kPhoton[i], kPhoton[i + 1], min(flown - (float)i, 1.f)), leg.x1, leg.y1);
        drawStrokes(frame, &leg, 1, h * 0.0012f, kSunlight, 1);
        leg.x0 = leg.x1, leg.y0 = leg.y1;
        float near = i < 2 ? 0 : max(flown - 3, 0.f);
        near *= near;
        drawStrokes(frame, &leg, 1, h * (0.004f + 0.02f * near), kSunlight * (1 + 40 * near), 1);
    }
    drawHemicube(hall, value(track(kRise), in.row), value(track(kOpen), in.row), view, frame);
}

} // namespace odraz

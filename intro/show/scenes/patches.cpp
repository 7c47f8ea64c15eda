// Scene 4. The hall before light: the point of light spreads the patches' lines through the dark. One patch
// is visited: its hemicube rises over it, unfolds into five pictures of what it sees, and gathers the light
// of the windows that they find. Then direct light strikes all patches, then bounce after bounce. The light
// that a bounce adds comes brightened, in a colour of its own (amber, rose, blue), and stays. The camera goes
// nearer each time, until it is inside, and patches become surfaces. The mirror ball rolls in. All data are
// the solver's: patches, hemicube, light after each bounce.
#include "base/maths.h"
#include "show/font.h"
#include "show/hemicube_view.h"
#include "show/point_of_light.h"
#include "show/scenes.h"
#include "timeline/keys.h"
#include "trace/picture/overlay.h"

namespace odraz {

#include "show/scenes/patches.keys"

static constexpr float kGrey = 0.6f; // albedo of all surfaces at first

// Direct light, then bounces: a stage a bar, and the factor by which its contribution is brightened when it
// comes, by colour.
static constexpr Rgb kGains[] = {{1, 1, 1}, {4.4f, 2.2f, 0.7f}, {6.6f, 3, 4.2f}, {2, 8, 26}};
static constexpr int kStages = sizeof kGains / sizeof *kGains, kStageRows = 16;
static_assert(kStages <= kBounces + 1 && rowOf(kBounce3) == rowOf(kDirectLight) + 3 * kStageRows);
static constexpr float kWave = 1.1f; // metres that the lines spread in a row
static constexpr Rgb kCopperLight = {1.9f, 0.86f, 0.42f}, kDarkCopper = {2.6f, 1.6f, 1.25f},
                     kPathColour = {1.2f, 0.8f, 0.5f};

// The stage of light at a row: below 0 before the direct light.
static int stageAt(float row) {
    return row < rowOf(kDirectLight) ? -1 : min((int)(row - rowOf(kDirectLight)) / kStageRows, kStages - 1);
}

// The number of the hemicube's faces that have found their windows: one each two rows, from a beat after it
// opens.
static float facesFound(float row) { return (row - rowOf(kHemicubeOpens) - 4) / 2; }

void posePatches(const SceneInput &in, Scene &scene) {
    float row = in.row;
    Hall *hall = in.hall;
    float melt = value(track(kMelt), row), real = value(track(kReal), row);
    HallLight light = {kNoon, {}, {}, real};
    poseHall(*hall, light, 1 - real, in.camera.eye, scene);
    PointOfLight point = pointOf(kPatches, row);
    addPoint(scene, point, 0.03f + 0.005f * length(point.at - in.camera.eye), {}); // seen from far, too
    if (row < rowOf(kPatchesMelt)) scene.sky = plainSky({}, {});
    scene.exposure = value(track(kExposure), row);
    scene.lines = value(track(kLines), row) * (1 - melt);
    hall->map.sharpness = exp2((1 - melt) * 10);
    hall->map.mosaic = 1 - melt;
    if (row >= rowOf(kBallRollsIn)) addGuest(scene, 268 - row);
    if (melt == 1) return;

    // Colour the patches: black before the lines arrive, a dark copper that depends on their normals, and
    // then their light
    const Model &m = hall->model;
    int stage = stageAt(row);
    Rgb gain = lerp(kGains[max(stage, 0)], Rgb{1, 1, 1},
                    value(track(kJoin), row - (rowOf(kDirectLight) + (float)(stage * kStageRows))));
    Vec3 corner = pointOf(kPatches, 0).at;
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        float wave = (row - rowOf(kLinesSpread)) * kWave - length(p.p - corner);
        Rgb own = kDarkCopper * ((0.006f + 0.0033f * c.n.y + 0.0024f * c.n.x - 0.0013f * c.n.z) *
                                 saturate(wave) * (0.5f + 3 * saturate(1 - 0.25f * wave)));
        if (stage >= 0 && p.share > 0) { // patches under the stair get no light
            Rgb before = stage ? hall->bounce[stage - 1][i] : Rgb{};
            // Use the patch's own reflectance instead of the common grey's, until its own material is shown
            own = (before + (hall->bounce[stage][i] - before) * gain) *
                  lerp(hall->mean[c.material] * (1 / kGrey), Rgb{1, 1, 1}, real);
        } else if (i == hall->visited && row >= rowOf(kHemicubeRises)) {
            own = lerp(kCopperLight * 0.45f, hall->bounce[1][i], saturate(facesFound(row) / 5));
        }
        hall->mosaic[0][i] = own.x, hall->mosaic[1][i] = own.y, hall->mosaic[2][i] = own.z;
    }
}

void letterPatches(const SceneInput &in, const View &view, Frame &frame) {
    const Hall &hall = *in.hall;
    float h = (float)frame.height;
    int stage = in.row < rowOf(kPatchesMelt) ? stageAt(in.row) : -1;
    if (stage >= 0) {
        char bounce[] = {'b', 'o', 'u', 'n', 'c', 'e', ' ', (char)('0' + stage), 0};
        drawText(frame, stage ? bounce : "direct light", view.width - h * 0.12f, h * 0.88f,
                 {h * 0.032f, 0.085f, Align::Right, {0.8f, 0.42f, 0.24f}});
    }
    // Draw the path of the point of light, a leg for each stage
    for (int i = 0; i <= stage; ++i) {
        float from = rowOf(kDirectLight) + (float)(i * kStageRows);
        Stroke leg;
        view.project(pointOf(kPatches, from).at, leg.x0, leg.y0);
        view.project(pointOf(kPatches, min(from + kStageRows - 0.01f, in.row)).at, leg.x1, leg.y1);
        drawStrokes(frame, &leg, 1, h * 0.0008f, kPathColour, 1);
    }
    drawHemicube(hall, value(track(kRise), in.row), value(track(kOpen), in.row), facesFound(in.row), view,
                 frame);
}

} // namespace odraz

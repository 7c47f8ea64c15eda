// Scene 7. The word of scene 1 on its marble, before the last ball. Text tells what the film is, how many
// bytes it has and what it ran on.
#include "base/text.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

using enum Interpolation;

enum { kMarble, kSilver };
static constexpr const Material *kMaterials[] = {[kMarble] = &kDarkMarble, [kSilver] = &kMirror};
static constexpr Light kLights[] = {
    {{-1.6f, 2.4f, 1.4f}, {5.5f, 4.4f, 3.1f}, 0.2f},
    {{2.6f, 1.7f, -2.6f}, {3.2f, 4.4f, 6.8f}, 0.2f},
    {{0, 0.07f, 0.6f}, {0.3f, 0.14f, 0.06f}, 0.1f},
};

void poseCredits(const Cue &, Scene &scene) {
    scene.addAll(kMaterials);
    scene.addAll(kLights);
    scene.add(plane({0, 0, 0}, kMarble))->textureShift = {3.1f, 0.37f, 1.9f};
    scene.add(sphere({0, 0.6f, -1.2f}, 0.6f, kSilver));
    int tube = scene.add(lamp({4.5f, 1.6f, 0.5f}));
    standText(scene, "odraz", {-1.17f, 0.004f, 0}, 0.045f, 100, tube);
    scene.ballsOcclude = true;
    scene.ambientLow = {0.01f, 0.01f, 0.014f};
    scene.ambientHigh = {0.016f, 0.018f, 0.026f};
    scene.sky = plainSky({0.004f, 0.005f, 0.008f}, {0.012f, 0.016f, 0.026f});
    scene.fog = 0.09f;
    scene.exposure = 1.3f;
}

static constexpr Key kFade1[] = {{rowOf(kLine1), 0, Smooth}, {rowOf(kLine1) + 10, 1, Linear}};
static constexpr Key kFade2[] = {{rowOf(kLine2), 0, Smooth}, {rowOf(kLine2) + 10, 1, Linear}};
static constexpr Key kFade3[] = {{rowOf(kLine3), 0, Smooth}, {rowOf(kLine3) + 10, 1, Linear}};

void letterCredits(const Cue &cue, const View &, Frame &frame) {
    float w = (float)frame.width, h = (float)frame.height;
    auto line = [&](const char *text, float y, float size, Track fade, Rgb colour) {
        drawText(frame, text, w * 0.5f, h * y, h * size, 0.085f, 1.6f, Align::Centre, colour,
                 value(fade, cue.row));
    };
    Rgb pale = {0.75f, 0.72f, 0.68f}, accent = {0.80f, 0.42f, 0.24f}, grey = {0.36f, 0.36f, 0.38f};
    line("a film of reflections, traced ray by ray while you watched", 0.13f, 0.023f, track(kFade1), pale);
    line("no picture and no sound was recorded", 0.19f, 0.023f, track(kFade2), grey);
    Text<80> size;
    if (cue.facts.bytes)
        size << cue.facts.bytes << " bytes";
    else
        size << "in less than 65537 bytes";
    line(size.data, 0.27f, 0.031f, track(kFade3), accent);
    Text<80> machine;
    machine << "on "
            << (cue.facts.machine && *cue.facts.machine ? cue.facts.machine
                                                        : "a processor, and nothing else");
    line(machine.data, 0.325f, 0.023f, track(kFade3), grey);
}

} // namespace odraz

// Scene 7. The word that the last ball mirrored, on the marble of scene 1. The text names the film's method,
// size, authors and processor, and greets the inventors of its methods.
#include "base/maths.h"
#include "base/text.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/credits.keys"

enum { kMarble, kSilver };
static constexpr const Material *kMaterials[] = {[kMarble] = &kDarkMarble, [kSilver] = &kMirror};
static constexpr float kLastBeat = 92; // then black, while the reverberation fades
// The start of each page of text and the end of the last; then the word is alone for two seconds
static constexpr float kPages[] = {rowOf(kLine1), rowOf(kLine2), rowOf(kLine3), kLastBeat - 16};

void poseCredits(const SceneInput &in, Scene &scene) {
    scene.addAll(kMaterials);
    // The light moves over the stone until the end
    float shift = in.row * 0.03f;
    scene.add(Light{{shift - 2.4f, 2.4f, 1.4f}, {5.5f, 4.4f, 3.1f}, 0.2f});
    scene.add(Light{{2.6f, 1.7f, -2.6f + shift}, {3.2f, 4.4f, 6.8f}, 0.2f});
    scene.add(Light{{0, 0.4f, 1.5f}, {0.3f, 0.14f, 0.06f}, 0.1f}); // the light of the word
    // The shift keeps bright veins out of the word's reflection
    scene.add(plane({0, 0, 0}, kMarble))->textureShift = {-4, -2.75f, 5.5f};
    scene.add(sphere({-1.95f, 0.6f, -1.2f}, 0.6f, kSilver));
    int tube = scene.add(lamp({4.5f, 1.6f, 0.5f}));
    addText(scene, "odraz", {-1.17f, 0.055f, 0}, 0.045f, 100, tube);
    scene.ballsOcclude = true;
    scene.ambientLow = {0.01f, 0.01f, 0.014f};
    scene.ambientHigh = {0.016f, 0.018f, 0.026f};
    scene.sky = plainSky({0.004f, 0.005f, 0.008f}, {0.012f, 0.016f, 0.026f});
    scene.fog = 0.09f;
    scene.exposure = in.row > kLastBeat ? 0 : 1.3f;
}

void letterCredits(const SceneInput &in, const View &, Frame &frame) {
    float w = (float)frame.width, h = (float)frame.height;
    auto line = [&](int page, const char *text, float y, float size, Rgb colour) {
        float shown = min(in.row - kPages[page], kPages[page + 1] - in.row);
        drawText(frame, text, w * 0.5f, h * y,
                 {h * size, 0.09f, Align::Centre, colour, value(track(kPage), shown)});
    };
    Rgb pale = {0.75f, 0.72f, 0.68f}, accent = {0.80f, 0.42f, 0.24f};
    Text<80> size, machine;
    if (in.facts.bytes)
        size << in.facts.bytes << " bytes";
    else
        size << "in less than 65537 bytes";
    machine << "on "
            << (in.facts.machine && *in.facts.machine ? in.facts.machine : "a processor, and nothing else");
    line(0, "light, traced ray by ray as you watched", 0.14f, 0.036f, pale);
    line(0, size.data, 0.24f, 0.046f, accent);
    line(0, "no picture and no sound was recorded", 0.33f, 0.036f, pale);
    line(1, "picture and music", 0.14f, 0.036f, pale);
    line(1, "the odraz team", 0.24f, 0.046f, accent);
    line(1, machine.data, 0.33f, 0.03f, pale);
    line(2, "greetings to those it stands on", 0.14f, 0.036f, pale);
    line(2, "whitted  kajiya  goral  cohen", 0.22f, 0.036f, accent);
    line(2, "greenberg  perlin  sloan  elias", 0.29f, 0.036f, accent);
}

} // namespace odraz

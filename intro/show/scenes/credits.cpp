// Scene 7. The word that the last ball mirrored, on the marble of scene 1. The text names the film's method,
// size, authors and processor, and greets the inventors of its methods.
#include "base/maths.h"
#include "base/text.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/point_of_light.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/credits.keys"

enum { kMarble, kSilver };
static constexpr const Material *kMaterials[] = {[kMarble] = &kDarkMarble, [kSilver] = &kMirror};
static constexpr Shape kShapes[] = {
    // The shift keeps bright veins out of the word's reflection
    {.kind = ShapeKind::Plane, .material = kMarble, .textureShift = {-4, -2.75f, 5.5f}},
    sphere({-2.05f, 0.75f, -1.35f}, 0.75f, kSilver),
};
static constexpr int kStrokes = 8; // in the word
// The start of each page of text and the end of the last
static constexpr float kPages[] = {rowOf(kLine1), rowOf(kLine2), rowOf(kLine3), rowOf(kWordGoes) + 6};

// The share of its light that a lamp has left, so many rows after it began to go out.
static float left(float rows) { return 1 - saturate(rows * 0.25f); }

void poseCredits(const SceneInput &in, Scene &scene) {
    scene.addAll(kMaterials);
    // The light moves over the stone, and dims when the word goes
    float shift = in.row * 0.03f, bright = left((in.row - rowOf(kWordGoes)) * 0.07f);
    scene.add(Light{{shift - 2.4f, 2.4f, 1.4f}, Rgb{5.5f, 4.4f, 3.1f} * bright, 0.2f});
    scene.add(Light{{2.6f, 1.7f, -2.6f + shift}, Rgb{3.2f, 4.4f, 6.8f} * bright, 0.2f});
    scene.addAll(kShapes);
    // What goes out can be seen in mirrors for a while
    addPoint(scene, pointOf(kCredits, in.row), 0.03f, {0.5f, 0.35f, 0.22f});
    scene.materials[scene.materialCount - 1].tint = Rgb{1, 1, 1} * left(in.row - rowOf(kPointGoesOut));
    int before = scene.materialCount - 1;
    for (int i = kStrokes - 1; i >= 0;
         --i) { // in the order in which they were written, the last stroke goes first
        Material m = lamp(Rgb{4.5f, 1.6f, 0.5f} * left(in.row - rowOf(kEchoesGo) - 2 * (float)i));
        m.tint = Rgb{1, 1, 1} * left(in.row - rowOf(kWordGoes) - 4 * (float)i);
        scene.add(m);
    }
    addText(scene, "odraz", {-1.17f, 0.055f, 0}, 0.045f, 100, before, 1);
    setGloom(scene, 0.85f);
    scene.exposure = 1.3f;
}

void letterCredits(const SceneInput &in, const View &, Frame &frame) {
    float w = (float)frame.width, h = (float)frame.height;
    auto line = [&](int page, const char *text, float y, float size, Rgb colour) {
        float shown = min(in.row - kPages[page], kPages[page + 1] + 2 - in.row);
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
    line(0, "light, traced ray by ray", 0.16f, 0.045f, pale);
    line(0, size.data, 0.25f, 0.055f, accent);
    line(0, "nothing was recorded", 0.34f, 0.045f, pale);
    line(1, "picture and music", 0.16f, 0.045f, pale);
    line(1, "the odraz team", 0.25f, 0.055f, accent);
    line(1, machine.data, 0.34f, 0.038f, pale);
    line(2, "greetings to", 0.16f, 0.045f, pale);
    line(2, "whitted  kajiya  goral  cohen", 0.25f, 0.046f, accent);
    line(2, "greenberg  perlin  sloan  elias", 0.34f, 0.045f, accent);
}

} // namespace odraz

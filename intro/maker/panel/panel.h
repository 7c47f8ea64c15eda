// The makers' panel over the picture: a time line, the camera from outside, the costs of the picture, the
// scene's materials, two qualities side by side. While hidden it costs nothing.
//
// The host calls steer() before a picture, and picture() instead of that of intro.h; keys and the mouse come
// from input.h, or from a test.
#pragma once

#include "maker/panel/compare.h"
#include "maker/panel/costs.h"
#include "maker/panel/ghost.h"
#include "maker/panel/keys.h"
#include "maker/panel/level.h"
#include "maker/panel/strip.h"
#include "maker/panel/swatches.h"

namespace odraz::maker {

// The picture of a time. `camera`: null for the film's own.
struct PictureRequest {
    double time; // seconds
    const Quality &quality;
    const CameraKey *camera;
};

class Panel {
public:
    // For pictures of this size; `rate`: pictures a second, for steps; `clock`: nanoseconds.
    Panel(int width, int height, double rate, int64_t (*clock)());

    // --- From input ---
    void act(Action action);
    enum class Button { Left, Right };
    void press(double x, double y, Button button); // pixels of the picture
    void move(double x, double y);
    void release();
    void wheel(double x, double y, double turns);
    bool grabs() const { return grabbed != Grab::None; } // the mouse, which the host must then not use

    // --- To the picture ---
    // Applies the actions since the last call to the host's time; `sought` is set when it jumps.
    void steer(double &time, bool &paused, bool &sought);
    Picture picture(Intro &intro, const PictureRequest &request);

    // To be called before the film's code is replaced, and after it.
    void forget() { envelope.stop(); }
    void learn();

    int pictureWidth() const { return width; }
    int pictureHeight() const { return height; }
    bool visible() const { return shown; }
    const Strip &timeLine() const { return strip; }
    const Loop &loop() const { return stretch; }
    int othersTraced() const { return others; } // the number of times that the other quality was traced
    const Costs &lastCosts() const { return costs; }
    const std::vector<uint32_t> &samples() const { return heat; }
    Rect inset() const; // with the view from outside

private:
    enum class Grab { None, Scrub, LoopEnd, Orbit, Divider };
    Picture makePicture(Intro &intro, const PictureRequest &request);
    void makeGhost(Intro &intro, const PictureRequest &request);
    bool makeOther(Intro &intro, const PictureRequest &request);
    void watchForChanges(const Picture &picture, const PictureRequest &request);
    void makeDifference(const Picture &picture, const PictureRequest &request);
    void draw(const Picture &picture, const PictureRequest &request);
    void drawComparison(Canvas &canvas, const PictureRequest &request);
    void drawInset(Canvas &canvas, const PictureRequest &request);
    void seek(double to);

    const Inspector *film; // of the film's code that is in use
    int width, height;
    double rate;
    int64_t (*clock)();
    Content content;
    Strip strip;
    Envelope envelope;
    Meter meter;
    Swatches swatches;
    GhostPlace place;
    Costs costs;
    Loop stretch;
    Probe probe;

    // What is shown
    bool shown = false, help = false, ghost = false, heated = false, materials = false, costly = true,
         split = false, differs = false;
    QualityName other = QualityName::Film;
    double divider = 0.5; // of the width
    Kept ghostPicture, otherPicture, lastPicture;
    int others = 0;
    Difference difference;
    float scale = 0; // of its map, until another comparison is asked for
    std::vector<uint32_t> heat;

    // What identifies a kept picture: its time, quality, the other quality, and the flown camera's numbers
    using Key = std::vector<double>;
    Key keyOf(const PictureRequest &request) const;
    Key otherKey, differenceKey, lastKey, lastPictureKey;

    // What the mouse does, and where it was
    Grab grabbed = Grab::None;
    double mouseX = -1, mouseY = -1, loopFrom = 0;

    // Since the last steer()
    double now = 0, wanted = -1, heardTo = 0;
    bool stop = false, waits = false; // waits: for the other picture to be traced
    int64_t last = 0;
};

} // namespace odraz::maker

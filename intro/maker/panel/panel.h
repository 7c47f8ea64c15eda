// The makers' panel over the picture: a time line, the costs of the picture, and a map of its samples. While
// hidden it costs nothing.
//
// The host calls steer() before a picture, and picture() instead of that of intro.h; keys and the mouse come
// from input.h, or from a test.
#pragma once

#include "maker/panel/costs.h"
#include "maker/panel/keys.h"
#include "maker/panel/strip.h"

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

    // To be called after the film's code was replaced.
    void learn();

    int pictureWidth() const { return width; }
    int pictureHeight() const { return height; }
    bool visible() const { return shown; }
    const Strip &timeLine() const { return strip; }
    const Loop &loop() const { return stretch; }
    const Costs &lastCosts() const { return costs; }
    const std::vector<uint32_t> &samples() const { return heat; }

private:
    enum class Grab { None, Scrub, LoopEnd };
    Picture makePicture(Intro &intro, const PictureRequest &request);
    void draw(Canvas &canvas, double time);
    void seek(double to);

    const Inspector *film; // of the film's code that is in use
    int width, height;
    double rate;
    int64_t (*clock)();
    Content content;
    Strip strip;
    Costs costs;
    Loop stretch;
    Probe probe;

    // What is shown
    bool shown = false, help = false, heated = false, costly = true;
    std::vector<uint32_t> heat;

    // What the mouse does, and where it was
    Grab grabbed = Grab::None;
    double mouseX = -1, mouseY = -1, loopFrom = 0;

    // Since the last steer()
    double now = 0, wanted = -1;
    bool stop = false;
};

} // namespace odraz::maker

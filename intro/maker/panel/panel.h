// The makers' panel over the picture: a time line, the costs of the picture, and a map of its samples. It
// costs nothing while hidden.
//
// The host calls steer() before a picture, and picture() instead of the function in intro.h. Keys and mouse
// events come from input.h, or from a test.
#pragma once

#include "maker/panel/costs.h"
#include "maker/panel/keys.h"
#include "maker/panel/strip.h"

namespace odraz::maker {

// What to show in a picture. `camera`: null for the film's own.
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
    bool grabs() const { return grabbed != Grab::None; } // true: the host must not use the mouse

    // --- To the picture ---
    // Applies the actions since the last call to the host's time. Sets `sought` if the time jumps.
    void steer(double &time, bool &paused, bool &sought);
    Picture picture(Intro &intro, const PictureRequest &request);

    // Reads the film's content again. Call this after its code has been replaced.
    void renew();

    int pictureWidth() const { return width; }
    int pictureHeight() const { return height; }
    bool visible() const { return shown; }
    const Strip &timeLine() const { return strip; }
    const Loop &loop() const { return stretch; }
    const PictureCosts &lastCosts() const { return costs; }
    const std::vector<uint32_t> &samples() const { return heat; }

private:
    enum class Grab { None, Scrub, LoopEnd };
    Picture makePicture(Intro &intro, const PictureRequest &request);
    void draw(Canvas &canvas, double time);
    void seek(double to);

    const Inspector *film; // from the code in use
    int width, height;
    double rate;
    int64_t (*clock)();
    Content content;
    Strip strip;
    PictureCosts costs;
    Loop stretch;
    Probe probe;

    // Visible parts
    bool shown = false, help = false, heatShown = false, costsShown = true;
    std::vector<uint32_t> heat;

    // The state and last position of the mouse
    Grab grabbed = Grab::None;
    double mouseX = -1, mouseY = -1, loopFrom = 0;

    // Requests since the last steer()
    double now = 0, wanted = -1;
    bool stop = false;
};

} // namespace odraz::maker

// The window of `view`: handles keys, mouse and wheel, and decides when to draw.
#pragma once

#include "tools/radiosity/view/background_solve.h"
#include "tools/radiosity/view/picture.h"
#include "tools/radiosity/view/relit_room.h"

#include <string>

struct GLFWwindow;

namespace odraz::radiosity {

struct ViewSettings {
    std::string name; // name of the model, for the title
    RenderSettings camera;
    bool placed = false; // the user placed the camera; otherwise it is placed as by `render`
    ViewLayers layers;
    std::string screenshot; // file to write; the window closes once it is written
    double spin =
        0; // if above 0: turns a room's sky once in this number of seconds, prints the rate and closes
};

class ViewWindow {
public:
    // Opens the window; there can be only one. Throws std::runtime_error with what is missing.
    explicit ViewWindow(const ViewSettings &settings);
    ~ViewWindow();
    ViewWindow(const ViewWindow &) = delete;

    void show(std::shared_ptr<const ViewMesh> mesh, const std::vector<Rgb> &light,
              const RenderSettings &camera);
    // Shows a room, which keys and mouse relight; it must outlive run().
    void show(RelitRoom &room, const RenderSettings &camera);
    // Runs until the window is closed or the screenshot is written. `solver` may be null.
    void run(BackgroundSolve *solver);
    static void wake();

private:
    void key(int key, bool shift);
    void wheel(double notches);
    void pointer(double x, double y);
    void takeNews(BackgroundSolve &solver);
    bool fly(float seconds);
    bool relight(float seconds);
    void toggle(bool ViewLayers::*layer);
    void drawChanges(bool moving);
    void pickPatch();
    float exposure() const; // that of targetTone, with stops
    bool adaptExposure(float seconds);
    void present();
    void title(const std::string &step);

    ViewSettings s;
    RenderSettings start; // the camera to return to
    GLFWwindow *window = nullptr;
    std::unique_ptr<ViewPicture> picture;
    float size = 0; // of the model; 0: no model yet
    RelitRoom *room = nullptr;
    ViewTone tone, targetTone;
    // The scene must be drawn; it must be tone-mapped; it was drawn at low quality; light was measured
    bool redraw = true, retone = true, rough = false, measured = false;
    bool solved = true; // the light shown is final
    int patch = 0, pictures = 0;
    double mouseX = 0, mouseY = 0;
    bool looking = false, turning = false; // the left button, the right one is held
    bool help = false;                     // shown over the picture
    float lookX = 0, lookY = 0, turnX = 0, turnY = 0;
    double spun = 0; // seconds
    int spunPictures = 0;
    int pointerX = 0, pointerY = 0;
    std::string shownTitle;
};

// GLFW is loaded when a window is opened, so that all other commands run without it. Makes the functions of
// <GLFW/glfw3.h> callable. Returns null, or a line with the error and its remedy.
const char *openGlfw();

} // namespace odraz::radiosity

// The window of `view`. It handles keys, mouse and wheel, and decides when to draw.
#pragma once

#include "tools/radiosity/view/background_solve.h"
#include "tools/radiosity/view/picture.h"
#include "tools/radiosity/view/relit_room.h"

#include <string>

struct GLFWwindow;

namespace odraz::radiosity {

struct ViewSettings {
    std::string name; // name of the file, for the title
    RenderSettings camera;
    bool placed = false; // the user placed the camera; otherwise placeCamera() does
    ViewLayers layers;
    std::string screenshot; // file to write; the window closes once it is written
    double spin = 0; // above 0: turn a room's sky once in this number of seconds, print the rate, and close
};

class ViewWindow {
public:
    // Opens the window; there can be only one. Throws std::runtime_error that names what is missing.
    explicit ViewWindow(const ViewSettings &settings);
    ~ViewWindow();
    ViewWindow(const ViewWindow &) = delete;

    void show(std::shared_ptr<const ViewMesh> mesh, const std::vector<Rgb> &light,
              const RenderSettings &camera);
    // Shows a room, which keys and mouse relight. The room must outlive run().
    void show(RelitRoom &room, const RenderSettings &camera);
    // Runs until the window is closed or the screenshot is written. `solver` may be null.
    void run(BackgroundSolve *solver);
    static void wake();

private:
    void key(int key, bool shift);
    void pointer(double x, double y);
    void takeNews(BackgroundSolve &solver);
    bool fly(float seconds);
    bool relight(float seconds);
    void toggle(bool ViewLayers::*layer);
    void drawChanges(bool moving);
    void pickPatch();
    float exposure() const; // targetTone's exposure with the user's stops
    bool adaptExposure(float seconds);
    void present();
    void title(const std::string &step);

    ViewSettings s;
    RenderSettings start; // the camera to return to
    GLFWwindow *window = nullptr;
    std::unique_ptr<ViewPicture> picture;
    float size = 0; // the model's ViewMesh::size; 0: no model yet
    RelitRoom *room = nullptr;
    ViewTone tone, targetTone;
    bool redraw = true, retone = true; // the scene must be drawn; it must be tone-mapped
    bool rough = false;                // the scene was drawn with one sample per pixel, because it moved
    bool measured = false;             // targetTone is known
    bool solved = true;                // the light shown is final
    int patch = 0;                     // the patch under the pointer; 0: none
    int pictures = 0;                  // number of times that new light was shown
    double mouseX = 0, mouseY = 0;
    bool looking = false, turning = false;            // the left button is held; the right button is held
    bool help = false;                                // help is shown over the picture
    float lookX = 0, lookY = 0, turnX = 0, turnY = 0; // mouse movement with these buttons, not handled yet
    double spun = 0;                                  // seconds of spinning
    int spunPictures = 0;
    int pointerX = 0, pointerY = 0; // pixel for which `patch` was found
    std::string shownTitle;
};

// Loads GLFW and makes the functions of <GLFW/glfw3.h> callable. The library is loaded when a window is
// opened, so that all other commands run without it. Returns null, or a line with the error and its remedy.
const char *openGlfw();

} // namespace odraz::radiosity

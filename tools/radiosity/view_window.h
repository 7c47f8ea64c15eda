// The window of `view`: keys, mouse and wheel; what is drawn when.
#pragma once

#include "tools/radiosity/view_growth.h"
#include "tools/radiosity/view_picture.h"

#include <string>

struct GLFWwindow;

namespace odraz {

struct ViewSettings {
    std::string name; // of what is shown, for the title
    RenderSettings camera;
    bool placed = false; // the camera is where the user wants it; else where render's would stand
    ViewLayers layers;
    std::string screenshot; // a file: then the window ends once it is written
};

class ViewWindow {
public:
    // Opens it. Throws std::runtime_error that tells what is missing. There is one at a time.
    explicit ViewWindow(const ViewSettings &settings);
    ~ViewWindow();
    ViewWindow(const ViewWindow &) = delete;

    void show(std::shared_ptr<const ViewMesh> mesh, const std::vector<Rgb> &light,
              const RenderSettings &camera);
    // Until it is closed or the screenshot is written. `growth` may be null.
    void run(ViewGrowth *growth);
    static void wake();

private:
    void key(int key);
    void wheel(double notches);
    void pointer(double x, double y);
    void hear(ViewGrowth &growth);
    bool fly(float seconds);
    void drawWhatChanged(bool moving);
    void pickPatch();
    float exposure() const; // that is wanted
    bool glide(float seconds);
    void present();
    void title(const std::string &step);

    ViewSettings s;
    RenderSettings start; // camera to come back to
    GLFWwindow *window = nullptr;
    std::unique_ptr<ViewPicture> picture;
    float size = 0; // of the model; 0: there is none yet
    ViewTone tone, wanted;
    // What there is to do: draw the scene, tone it; whether it was drawn in a hurry; whether some light was
    // measured
    bool redraw = true, toned = true, rough = false, lit = false;
    bool solved = true; // nothing comes after this light
    int patch = 0, pictures = 0;
    double mouseX = 0, mouseY = 0;
    bool looking = false; // the left button is held
    bool help = false;    // lies over the picture
    float lookX = 0, lookY = 0;
    int pointerX = 0, pointerY = 0;
    std::string titled;
};

} // namespace odraz

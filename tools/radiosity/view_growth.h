// A model that is solved on a thread of its own while it is looked at. That thread makes all that is shown,
// and hands it over whole.
#pragma once

#include "tools/radiosity/solve_options.h"
#include "tools/radiosity/view_mesh.h"

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

namespace odraz {

// What came since it was asked last; null where nothing did.
struct ViewNews {
    std::shared_ptr<const ViewMesh> mesh;
    RenderSettings camera; // with the mesh: from where `render` would look at it
    std::shared_ptr<const std::vector<Rgb>> light;
    int pictures = 0; // that light was shown so often: of direct light, while it grew, and at the end
    bool done = false;
    std::vector<std::string> notes; // at the end, as `solve` tells them
};

class ViewGrowth {
public:
    // Starts, and returns when OpenGL is open there: that sets the environment, which nobody may read then.
    // `wake` is called after news, on that thread.
    ViewGrowth(Mesh mesh, BakeSettings settings, const RenderSettings &camera, void (*wake)());
    ViewGrowth(const ViewGrowth &) = delete;
    ~ViewGrowth(); // waits for the end

    // Throws what ended the thread.
    ViewNews take();
    std::string step(); // what it does, in a few words
    void stop() { __atomic_store_n(&stopped, 1, __ATOMIC_RELAXED); }

private:
    void run();
    bool looks();
    void look(const Bake &bake, const float *radiosity);
    void hand(bool geometry, bool done);

    Mesh mesh;
    BakeSettings settings;
    RenderSettings camera;
    void (*wake)();
    int stopped = 0;
    // Of the thread alone: what was shown last, and when to look again
    std::unique_ptr<Baked> baked;
    std::shared_ptr<const ViewMesh> shown;
    double next = 0, began = 0;
    bool looking = false; // since `began`
    // Of both, under the lock
    std::mutex lock;
    std::condition_variable opened;
    ViewNews news;
    std::string does = "starting";
    bool open = false;
    std::exception_ptr wrong;
    std::thread thread; // begins when all else is there
};

} // namespace odraz

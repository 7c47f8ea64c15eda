// Solves a model on another thread while the user looks at it. That thread makes all that is shown.
#pragma once

#include "tools/radiosity/export/render.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"
#include "tools/radiosity/view/mesh.h"

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

namespace odraz::radiosity {

// What changed since the last call; pointers are null where nothing did.
struct SolveNews {
    std::shared_ptr<const ViewMesh> mesh;
    RenderSettings camera; // comes with the mesh: where `render` would look from
    std::shared_ptr<const std::vector<Rgb>> light;
    int pictures = 0; // how often light was shown: direct light, while it grew, and at the end
    bool done = false;
    std::vector<std::string> notes; // at the end, as `solve` prints them
};

class BackgroundSolve {
public:
    // Starts the thread, and returns when it has opened OpenGL: that changes the environment, which no other
    // thread may read meanwhile. `wake` is called on the solver's thread after each change.
    BackgroundSolve(Mesh mesh, SolveSettings settings, const RenderSettings &camera, void (*wake)());
    BackgroundSolve(const BackgroundSolve &) = delete;
    ~BackgroundSolve(); // waits for the end

    // Throws the error that ended the thread.
    SolveNews take();
    std::string step(); // what it does now, in a few words
    void stop() { __atomic_store_n(&stopped, 1, __ATOMIC_RELAXED); }

private:
    void run();
    bool lightIsDue();
    void look(const Solution &soFar);
    void publish(bool geometry, bool done);

    Mesh mesh;
    SolveSettings settings;
    RenderSettings camera;
    void (*wake)();
    int stopped = 0;
    // Used only by the thread: the solution shown last, and when to look again
    std::unique_ptr<Solution> solution;
    std::shared_ptr<const ViewMesh> shown;
    double next = 0, began = 0;
    bool looking = false; // since `began`
    // Used by both threads, under the lock
    std::mutex lock;
    std::condition_variable opened;
    SolveNews news;
    std::string does = "starting";
    bool open = false;
    std::exception_ptr wrong;
    std::thread thread; // last member: starts when all others exist
};

} // namespace odraz::radiosity

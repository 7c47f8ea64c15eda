// Solves a model on another thread while the user looks at it. That thread computes the meshes and light to
// show.
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

// The changes since the last call; a pointer is null if nothing changed.
struct SolveNews {
    std::shared_ptr<const ViewMesh> mesh;
    RenderSettings camera; // set together with `mesh`: `render`'s camera
    std::shared_ptr<const std::vector<Rgb>> light;
    int pictures =
        0; // the number of times that light was published: direct light, after sweeps, and at the end
    bool done = false;
    std::vector<std::string> notes; // set at the end: those of `solve`
};

class BackgroundSolve {
public:
    // Starts the thread, and returns when it has opened OpenGL, because that changes the environment, which
    // no other thread may read meanwhile. `wake` is called on the solver's thread after each change.
    BackgroundSolve(Mesh mesh, SolveSettings settings, const RenderSettings &camera, void (*wake)());
    BackgroundSolve(const BackgroundSolve &) = delete;
    ~BackgroundSolve(); // waits for the end

    // Throws the error that ended the thread.
    SolveNews take();
    std::string step(); // the current step, in a few words
    void stop() { __atomic_store_n(&stopped, 1, __ATOMIC_RELAXED); }

private:
    void run();
    bool lightIsDue();
    void receive(const Solution &soFar);
    void publish(bool geometry, bool done);

    Mesh mesh;
    SolveSettings settings;
    RenderSettings camera;
    void (*wake)();
    int stopped = 0;
    // Used only by the thread: the solution shown last, and the time to publish again
    std::unique_ptr<Solution> solution;
    std::shared_ptr<const ViewMesh> shown;
    double next = 0, began = 0;
    bool computing = false; // since `began`
    // Used by both threads, under the lock
    std::mutex lock;
    std::condition_variable opened;
    SolveNews news;
    std::string currentStep = "starting";
    bool open = false;
    std::exception_ptr error;
    std::thread thread; // last member, because it uses all others
};

} // namespace odraz::radiosity

// Solves a model on a thread of its own, which also computes the meshes and the light to show.
#pragma once

#include "tools/radiosity/export/render.h"
#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/solution/solve_settings.h"
#include "tools/radiosity/view/mesh.h"

#include <exception>
#include <memory>
#include <mutex>
#include <semaphore>
#include <thread>

namespace odraz::radiosity {

// The changes since the last call of takeNews(). A pointer is null if nothing changed.
struct SolveNews {
    std::shared_ptr<const ViewMesh> mesh;
    RenderSettings camera; // set together with `mesh`, as placed by placeCamera()
    std::shared_ptr<const std::vector<Rgb>> light;
    bool done = false;
    std::vector<std::string> notes; // SolveReport::notes, set at the end
};

class BackgroundSolve {
public:
    // Starts the thread and waits until it has opened OpenGL: this changes the environment, which no other
    // thread may read meanwhile. `wake` is called on the solver's thread after each change.
    BackgroundSolve(Mesh mesh, SolveSettings settings, const RenderSettings &camera, void (*wake)());
    BackgroundSolve(const BackgroundSolve &) = delete;
    ~BackgroundSolve() { stop(); } // `thread` waits for its end

    // Returns the news. Throws the error that ended the thread.
    SolveNews takeNews();
    std::string step(); // the current step and its progress, for the title
    void stop() { __atomic_store_n(&stopped, 1, __ATOMIC_RELAXED); }

private:
    void run();
    void watch(const std::function<const Solution &()> &light);
    void publish(bool geometry, bool done);

    Mesh mesh;
    SolveSettings settings;
    RenderSettings camera;
    void (*wake)();
    int stopped = 0;
    // Used only by the solver's thread
    std::unique_ptr<Solution> solution; // the solution published last
    std::shared_ptr<const ViewMesh> shown;
    double next = 0; // when to compute light again, by the wall clock
    // Used by both threads, under the lock
    std::mutex lock;
    std::counting_semaphore<2> opened{0}; // released when OpenGL is open, and after an error
    SolveNews news;
    std::string currentStep = "starting";
    std::exception_ptr error;
    std::jthread thread; // last member, because it uses all others
};

} // namespace odraz::radiosity

// A room that `view` relights: the settings that keys and mouse change, and the resulting light.
//
// When the number of clusters changes, another thread finds them; until then the old ones are shown.
#pragma once

#include "tools/radiosity/transfer/relight_options.h"
#include "tools/radiosity/view/mesh.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace odraz::radiosity {

class RelitRoom {
public:
    // `wake` is called on the thread that finds clusters, when it is done or has failed. Throws Refused.
    RelitRoom(TransferRoom room, const RelightOptions &options, void (*wake)());
    ~RelitRoom();
    RelitRoom(const RelitRoom &) = delete;

    const Solution &model() const { return lit; }
    std::shared_ptr<const ViewMesh> mesh() const { return shown; }

    // Handles one of GLFW's keys; false if it has no meaning here. `shift`: Shift is held.
    bool key(int key, bool shift);
    // Rotates the sky, about the upward axis and by tilting it, in degrees.
    void turn(double around, double up);
    // The light that an eye sees at each point of the mesh; null if it has not changed.
    const std::vector<Rgb> *light(const Vec3 &eye);

    std::string title() const;          // its settings, abbreviated
    std::string commandOptions() const; // the same as options of `render`

private:
    TransferRoom room;
    RelightOptions options;
    Relighter relighter;
    Projected sky;
    Lighting lighting;
    double around, tilt;
    std::vector<float> strengths; // of each lamp when it is on
    int exactRank;                // the rank to restore after exact rows
    Solution lit;
    std::shared_ptr<const ViewMesh> shown;
    std::vector<Rgb> points;
    Vec3 seenFrom = {};
    bool changed = true;
    Clusters clusters; // in use
    int requested;     // number of clusters

    void (*wake)();

    // Used by both threads, under the lock
    std::mutex lock;
    std::condition_variable asked;
    int order = 0; // clusters to find; 0: none, -1: end
    bool fresh = false;
    int failed = 0; // clusters that could not be found; 0: none
    std::string whyFailed;
    Clusters found;
    std::thread finder; // last member, because it uses all others

    void findOthers();
    void setClusters(int count);
};

} // namespace odraz::radiosity

// A room that `view` relights: the settings of keys and mouse, and the light that they give.
//
// Other numbers of clusters are found on a thread of their own; until then the old ones are shown.
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
    // `wake` is called on the thread that finds clusters, when it has found some or failed. Throws Refused.
    RelitRoom(TransferRoom room, const RelightOptions &options, void (*wake)());
    ~RelitRoom();
    RelitRoom(const RelitRoom &) = delete;

    const Solution &model() const { return lit; }
    std::shared_ptr<const ViewMesh> mesh() const { return shown; }

    // Handles a key of GLFW's; false if it has no meaning here. `shift`: it is pressed with Shift.
    bool key(int key, bool shift);
    // Turns and tilts the sky by degrees.
    void turn(double around, double up);
    // The light that an eye sees at each point of the mesh; null if it has not changed.
    const std::vector<Rgb> *light(const Vec3 &eye);

    std::string title() const;          // its settings, in short
    std::string commandOptions() const; // the same as options of `render`

private:
    TransferRoom room;
    RelightOptions options;
    Relighter relighter;
    Projected sky;
    Lighting lighting;
    double around, tilt;
    std::vector<float> strengths; // of each lamp when it is on
    int exactRank;                // the rank to return to from exact rows
    Solution lit;
    std::shared_ptr<const ViewMesh> shown;
    std::vector<Rgb> points;
    Vec3 seenFrom = {};
    bool changed = true;
    Clusters clusters; // in use
    int wanted;        // how many clusters

    void (*wake)();

    // Used by both threads, under the lock
    std::mutex lock;
    std::condition_variable asked;
    int order = 0; // clusters to find; 0: none, -1: end
    bool fresh = false;
    int failed = 0; // clusters that could not be found; 0: none
    std::string whyFailed;
    Clusters found;
    std::thread finder; // last member: starts when all others exist

    void findOthers();
    void setClusters(int count);
};

} // namespace odraz::radiosity

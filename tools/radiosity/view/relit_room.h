// A room that `view` relights: the settings that keys and mouse change, and the resulting light.
//
// Another thread finds new clusters when their number changes; the old ones are shown meanwhile.
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
    // `wake` is called on the thread that finds clusters when it has found them or failed. Throws Refused.
    RelitRoom(TransferRoom room, const RelightOptions &options, void (*wake)());
    ~RelitRoom();
    RelitRoom(const RelitRoom &) = delete;

    const Solution &model() const { return lit; }
    std::shared_ptr<const ViewMesh> mesh() const { return shown; }

    // Handles a GLFW key; returns false if the key has no meaning here. `shift`: Shift is held.
    bool key(int key, bool shift);
    // Rotates the sky about the axis that points up, and tilts it, in degrees.
    void turn(double around, double up);
    // The radiosity of each point of the mesh, with gloss towards the eye; null if it has not changed.
    const std::vector<Rgb> *light(const Vec3 &eye);

    std::string title() const;          // the settings, for the title
    std::string commandOptions() const; // the settings as options of `render`

private:
    TransferRoom room;
    RelightOptions options;
    Relighter relighter;
    Projected sky;
    Lighting lighting;
    double around, tilt;
    std::vector<float> strengths; // strength of each lamp when it is on
    int lastRank;                 // the rank to restore after exact rows
    Solution lit;
    std::shared_ptr<const ViewMesh> shown;
    std::vector<Rgb> points;
    Vec3 lastEye = {};
    bool changed = true;
    Clusters clusters; // the clusters in use
    int requested;     // the number of clusters last asked for

    void (*wake)();

    // Used by both threads, under the lock
    std::mutex lock;
    std::condition_variable asked;
    int toFind = 0;     // number of clusters to find; 0: none, -1: end the thread
    bool isNew = false; // `found` is not in use yet
    int failed = 0;     // number of clusters that could not be found; 0: none
    std::string whyFailed;
    Clusters found;
    std::thread finder; // last member, because it uses all others

    void findOthers();
    void setClusters(int count);
};

} // namespace odraz::radiosity

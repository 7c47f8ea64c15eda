// A room that `view` relights: the settings that keys and mouse change, and the resulting light.
//
// Another thread finds new clusters when their number changes; the old ones are shown meanwhile.
#pragma once

#include "tools/radiosity/transfer/relight_options.h"
#include "tools/radiosity/view/mesh.h"

#include <future>
#include <memory>
#include <thread>

namespace odraz::radiosity {

class RelitRoom {
public:
    // `wake` is called on the thread that finds clusters when it has found them or failed. Throws Refused.
    RelitRoom(TransferRoom room, const RelightOptions &options, void (*wake)());
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
    int finding = 0; // the number of clusters that `finder` finds
    std::future<Clusters> found;
    std::jthread finder; // last member, because it uses others until its end

    void findOthers();
    void takeOthers();
};

} // namespace odraz::radiosity

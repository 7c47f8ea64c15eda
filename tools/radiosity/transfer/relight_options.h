// The options that light a room: for `render`, `export` and `view` of what `transfer` wrote.
#pragma once

#include "tools/common/command_line.h"
#include "tools/radiosity/transfer/environment.h"
#include "tools/radiosity/transfer/relight.h"

namespace odraz::radiosity {

class RelightOptions {
public:
    // `view` has a --sky of its own, which may be that of a model.
    void addTo(common::CommandLine &line, bool withSky = true);
    // Throws Refused if one of them was given: what is at `path` is no room. Call it after parse().
    static void refuseFor(const std::string &path, const common::CommandLine &line);
    // Finds other clusters for the room if the options ask for another number of them, as `view` does.
    void changeClusters(TransferRoom &room, Workers &workers) const;
    double turn() const { return around; } // degrees
    double tilt() const { return up; }

    struct Light {
        Lighting lighting;
        Projected sky; // before it was turned
    };
    // The light of a room. Without --sky it is dark outside; if the room has no lamps either, an even sky of
    // radiance 1 lights it. Prints what the bands lose of a picture. Throws Refused.
    Light of(const TransferRoom &room) const;

    std::string sky; // the value of --sky

private:
    std::string lamps;
    double around = 0, up = 0;
    int bands = 0, clusters = 0, rank = -1;
};

// Places the camera for what was read, which is a room or null; returns the eye.
using EyeFor = std::function<Vec3(const Solution &, const TransferRoom *)>;

// Reads a solution; or a room, lit by the options, with gloss towards the eye that `eyeFor` places (null:
// without gloss). Throws Refused if there are options for a room, but the file is none.
Solution readLit(const std::string &path, const RelightOptions &options, const common::CommandLine &line,
                 Workers &workers, const EyeFor &eyeFor = nullptr);

} // namespace odraz::radiosity

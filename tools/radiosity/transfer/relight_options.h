// The options of `render`, `export` and `view` that light a room.
#pragma once

#include "tools/common/command_line.h"
#include "tools/radiosity/transfer/environment.h"
#include "tools/radiosity/transfer/relight.h"

namespace odraz::radiosity {

class RelightOptions {
public:
    // `withSky` is false in `view`, which defines --sky itself, because it may belong to a model.
    void addTo(common::CommandLine &line, bool withSky = true);
    // Throws Refused if one of these options was given, because `path` is not a room. Call it after parse().
    static void refuseFor(const std::string &path, const common::CommandLine &line);
    // Finds new clusters for the room if the options ask for another number of clusters.
    void changeClusters(TransferRoom &room, Workers &workers) const;

    // The light of a room, and the sky before its rotation. Without --sky no light comes from outside, unless
    // the room has no lamps: then an even sky of radiance 1 lights it. Prints the share of a picture's energy
    // that the bands lose. Throws Refused.
    Lighting of(const TransferRoom &room, Projected *sky = nullptr) const;

    std::string sky;           // the value of --sky
    double turn = 0, tilt = 0; // degrees

private:
    std::string lamps;
    int bands = 0, clusters = 0, rank = -1;
};

// Places the camera for a solution and returns the eye. The room is null if the file is a solution.
using EyeFor = std::function<Vec3(const Solution &, const TransferRoom *)>;

// Reads a solution, or a room lit as the options ask, with gloss towards the eye that `eyeFor` returns (null:
// without gloss). Throws Refused if options for a room are given for a solution.
Solution readLit(const std::string &path, const RelightOptions &options, const common::CommandLine &line,
                 Workers &workers, const EyeFor &eyeFor = nullptr);

} // namespace odraz::radiosity

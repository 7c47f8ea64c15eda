// The options that light a room: for `render`, `export` and `view` of what `transfer` wrote.
#pragma once

#include "tools/common/arguments.h"
#include "tools/radiosity/transfer/environment.h"
#include "tools/radiosity/transfer/relight.h"

namespace odraz::radiosity {

class RelightOptions {
public:
    // Whether it is one of these options; if so, takes its value. Throws Refused.
    bool take(const std::string &option, common::Arguments &words);
    const std::string &first() const { return given; } // the first one that was taken; empty: none
    const std::string &skyWord() const { return sky; }
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

private:
    std::string given, sky, lamps;
    double around = 0, up = 0;
    int bands = 0, clusters = 0, rank = -1;
};

// Places the camera for what was read, which is a room or null; returns the eye.
using EyeFor = std::function<Vec3(const Solution &, const TransferRoom *)>;

// Reads a solution; or a room, lit as the options say, with gloss towards the eye that `eyeFor` places (null:
// without gloss). Throws Refused if there are options for a room, but the file is none.
Solution readLit(const std::string &path, const RelightOptions &options, Workers &workers,
                 const EyeFor &eyeFor = nullptr);

} // namespace odraz::radiosity

// One gather by hemicubes at some patches of a model, from known light: it measures rasters, anti-aliasing
// and hemicubes at corners alone.
#pragma once

#include "tools/picture/picture.h"
#include "tools/radiosity/study/study.h"

namespace odraz::radiosity {

// A hemicube's eye near corner k of a patch, a tenth of its side inside; in its middle if part of the patch
// is hidden.
Eye cornerEye(const Model &model, int patch, int k);

class Gathering {
public:
    // `divided`: Study::divide()'s, which stays. Up to `count` patches gather.
    Gathering(Study &study, const Solved &divided, int count);

    size_t count() const { return patches.size(); }

    // The hemicubes of a patch: one, several that are turned differently, or four at its corners.
    struct Way {
        int px, turns;
        bool corners;
    };
    struct Result {
        LightErrors errors;       // of what arrives at the patches
        double seconds;           // of the processor, a patch
        std::vector<float> light; // luminance of what arrives at each
    };
    Result measure(const Way &way);

    // The picture in a patch's hemicube, unfolded: the top face and the half faces around it, in the tone of
    // logarithmicTone().
    pictures::Image unfolded(int patch, int px);
    // The patch that sees most different patches of those that gather.
    int curious();

private:
    Study &study;
    const Model &model;
    std::vector<int> patches;    // that gather
    std::vector<Rgb> radiosity;  // of all patches, by the reference
    std::vector<float> outside;  // luminance of the light that reaches the gathering ones otherwise
    std::vector<float> expected; // luminance of all that arrives there, by the reference
};

} // namespace odraz::radiosity

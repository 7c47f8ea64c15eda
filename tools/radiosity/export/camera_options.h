// The options of `render` and `view` that set the camera and the brightness.
#pragma once

#include "tools/common/command_line.h"
#include "tools/radiosity/export/render.h"

namespace odraz::radiosity {

class CameraOptions {
public:
    void addTo(common::CommandLine &line);
    // Call it after parse(). Throws Refused if only half of a camera is given.
    void finish(const common::CommandLine &line);

    // Sets the axis that points up to a room's, unless --up was given.
    void useUpOf(bool upIsZ) {
        if (!up) settings.upIsZ = upIsZ;
    }

    // Makes the points in `settings` relative to Solution::origin. Call it for every solution.
    void moveTo(const Vec3 &origin);

    RenderSettings settings;
    bool placed = false; // options place the camera

private:
    bool up = false;             // --up was given
    Vec3d eye = {}, target = {}; // in model coordinates
};

// The options that place this camera: --eye X,Y,Z --at X,Y,Z. Moves the camera to the rounded position
// that they state.
std::string placeOptions(RenderSettings &settings);
// The same, followed by all other options of the picture.
std::string cameraLine(RenderSettings settings);

} // namespace odraz::radiosity

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

    // Sets the axis that points up to a room's, unless an option set it.
    void upOf(bool upIsZ) {
        if (!up) settings.upIsZ = upIsZ;
    }

    // Makes the camera's places in `settings` relative to Solution::place. Call it for every solution.
    void moveTo(const Vec3 &place);

    RenderSettings settings;
    bool placed = false; // by options

private:
    bool up = false;
    Vec3d eye = {}, target = {}; // in the model's coordinates
};

// The options that place this camera: --eye X,Y,Z --at X,Y,Z. Moves the camera to the rounded numbers.
std::string placeOptions(RenderSettings &settings);
// The same with all other options of the picture.
std::string cameraLine(RenderSettings settings);

} // namespace odraz::radiosity

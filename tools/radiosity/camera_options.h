// The options that say from where a solution is seen, and how bright: those of `render` and of `view`.
#pragma once

#include "tools/common/arguments.h"
#include "tools/radiosity/baked.h"

namespace odraz {

class CameraOptions {
public:
    // Whether it is one of them; then its value is taken. Throws Refused.
    bool take(const std::string &option, Arguments &words);
    // Throws Refused where there is half a camera.
    void finish(const std::string &command) const;

    RenderSettings settings;
    bool placed() const { return eye; }

private:
    bool eye = false, at = false;
};

// The words that say where a camera stands: --eye X,Y,Z --at X,Y,Z. It stands then where they say, as
// rounded.
std::string placeAsTold(RenderSettings &settings);
// With all else that is needed for the same picture.
std::string cameraAsTold(RenderSettings settings);

} // namespace odraz

// For libFuzzer: whatever a picture of the sky holds, `radiosity solve --sky` either refuses it with one line
// or makes a sky and suns from it. Writes into the current folder.
#include "tools/common/command_line.h"
#include "tools/radiosity/read/surroundings.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

using namespace odraz;
using namespace odraz::radiosity;

static void mustBeLight(const Rgb &c) {
    for (float x : {c.x, c.y, c.z})
        if (!(x >= 0 && std::isfinite(x))) std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    std::ofstream("a.hdr") << std::string((const char *)data, size);
    try {
        std::vector<Sun> suns;
        SkyPicture sky = readSky("a.hdr", size % 2 == 1, suns);
        if (suns.size() > 24) std::abort();
        for (const Sun &s : suns) {
            mustBeLight(s.light);
            if (std::fabs(length(s.towards) - 1) > 1e-3f) std::abort();
        }
        for (const Rgb &c : sky.pixels) mustBeLight(c);
        for (int k = 0; k < 200; ++k) {
            float up = (float)(k % 21) / 10 - 1, flat = std::sqrt(std::max(1 - up * up, 0.f));
            mustBeLight(sky.radiance({flat * std::cos((float)k), up, flat * std::sin((float)k)}));
        }
    } catch (const common::Refused &) {
    }
    return 0;
}

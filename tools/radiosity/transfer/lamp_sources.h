// The lamps of a room. Each is one basis of its light.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

// One lamp of the model or of the settings.
struct LampSource {
    std::string name;
    std::vector<size_t> materials; // those that emit its light
    Surroundings around;           // a ball or a sun
};

// All materials that emit and are used, then the balls and suns.
std::vector<LampSource> lampsOf(const Mesh &mesh, const Surroundings &around);

// Combines lamps from number kMaxLamps on into one, with a note.
void joinLamps(std::vector<LampSource> &lamps, std::vector<std::string> &notes);

} // namespace odraz::radiosity

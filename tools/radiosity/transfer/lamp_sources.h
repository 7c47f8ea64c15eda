// The lamps of a room: each of them is one basis of its light.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

// A light of the model or of the settings, of which the rest is dark.
struct LampSource {
    std::string name;
    std::vector<size_t> materials; // those that emit
    Surroundings around;           // a ball or a sun
};

// All materials that emit and are used, then the balls and suns.
std::vector<LampSource> lampsOf(const Mesh &mesh, const Surroundings &around);

// Makes the last lamp that there is room for (kMaxLamps) stand for all others, with a note.
void joinLamps(std::vector<LampSource> &lamps, std::vector<std::string> &notes);

} // namespace odraz::radiosity

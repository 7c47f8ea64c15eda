// Changes of materials by options: other reflectances, other power of lamps.
#pragma once

#include "tools/common/command_line.h"

#include <array>
#include <string>
#include <vector>

namespace odraz::radiosity {

struct MeshMaterial;

// What `--reflectance` or `--power` asks, as [NAME=]R,G,B or [NAME=]FACTOR.
struct MaterialChange {
    std::string option, text; // as they were given
    bool power;               // --power: what the material emits; else what it reflects
    std::string name;         // of a material; empty: all of them, or for power all that emit
    bool factor;              // multiplies the three values; else replaces them
    std::array<double, 3> value;
};

// Reads the option's value. NAME ends at the last "=". Throws Refused if there is no such colour or factor:
// reflectances lie between 0 and 1, powers between 0 and 1e12, factors between 0 and 1e12.
MaterialChange readMaterialChange(const std::string &option, const std::string &text);

// Adds --reflectance and --power to a command line, in a group of this title.
inline constexpr char kMaterialGroup[] = "Other materials than the model's; FACTOR multiplies what it has";
void addMaterialChanges(common::CommandLine &line, std::vector<MaterialChange> &to);

// Makes the changes, one after the other, in those materials that are `used`. A colour replaces a picture, a
// factor multiplies it. Throws Refused if no used material has the name, if a reflectance comes out above 1
// or a power above 1e12, and for a factor where nothing emits.
void changeMaterials(std::vector<MeshMaterial> &materials, const std::vector<bool> &used,
                     const std::vector<MaterialChange> &changes);

} // namespace odraz::radiosity

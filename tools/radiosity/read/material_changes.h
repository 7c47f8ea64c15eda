// Changes to the model's materials by options: reflectance and the power of lamps.
#pragma once

#include "tools/common/command_line.h"
#include "tools/picture/picture.h"

#include <array>
#include <string>
#include <vector>

namespace odraz::radiosity {

struct MeshMaterial;

inline constexpr double kMostPower = pictures::kMostLight; // the largest --power and Ke

// The value of `--reflectance` or `--power`: [NAME=]R,G,B or [NAME=]FACTOR.
struct MaterialChange {
    std::string option, text; // the option and its value, as given
    bool power;               // true: emission (--power); false: reflectance
    std::string name;         // empty: all materials, or with --power all that emit
    bool factor;              // true: multiplies the three values; false: replaces them
    std::array<double, 3> value;
};

// Reads the option's value. NAME ends at the last "=". Throws Refused if a number is missing or out of range:
// 0 to 1 for reflectance, 0 to 1e12 for power and factors.
MaterialChange readMaterialChange(const std::string &option, const std::string &text);

// Adds --reflectance and --power to a command line, in the group kMaterialGroup.
inline constexpr char kMaterialGroup[] = "Changes to materials; FACTOR multiplies the model's value";
void addMaterialChanges(common::CommandLine &line, std::vector<MaterialChange> &to);

// Applies the changes in order to the materials that are `used`. A colour replaces a picture, a factor
// multiplies it. Throws Refused if no used material has the name, if a reflectance exceeds 1 or a power 1e12,
// or if a factor is given for power and nothing emits.
void changeMaterials(std::vector<MeshMaterial> &materials, const std::vector<bool> &used,
                     const std::vector<MaterialChange> &changes);

} // namespace odraz::radiosity

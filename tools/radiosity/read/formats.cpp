// The formats of models that can be read: a row each.
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/gltf_file.h"
#include "tools/radiosity/read/gltf_reader.h"
#include "tools/radiosity/read/obj_reader.h"

#include <algorithm>
#include <cctype>

namespace odraz::radiosity {

namespace {

struct Format {
    std::vector<const char *> endings; // of files' names, in small letters
    bool (*begins)(std::string_view start);
    decltype(&readModel) read;
    decltype(&readMaterialsAgain) readMaterials;
};
const Format kFormats[] = {{{".gltf", ".glb"}, isGltf, readGltf, readGltfMaterials},
                           {{".obj"}, [](std::string_view) { return true; }, readObj, readObjMaterials}};

const Format &formatOf(const std::string &path) {
    const std::string start = common::readStart(path, 64);
    return *std::find_if(std::begin(kFormats), std::end(kFormats),
                         [&](const Format &format) { return format.begins(start); });
}

} // namespace

bool isModel(const std::string &path) {
    std::string name = path;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const Format &format : kFormats)
        for (const char *ending : format.endings)
            if (name.ends_with(ending)) return true;
    try {
        return isGltf(common::readStart(path, 64));
    } catch (const common::Refused &) {
        return false; // readers report why
    }
}

Mesh readModel(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    return formatOf(path).read(path, settings, notes);
}

std::vector<MeshMaterial> readMaterialsAgain(const std::string &path, const MaterialNames &names,
                                             const std::vector<MaterialChange> &changes,
                                             std::vector<std::string> &notes) {
    return formatOf(path).readMaterials(path, names, changes, notes);
}

} // namespace odraz::radiosity

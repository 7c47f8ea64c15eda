// The formats of models that can be read: a row each.
#include "tools/radiosity/read/obj_reader.h"

#include <algorithm>
#include <cctype>

namespace odraz::radiosity {

namespace {

struct Format {
    const char *ending; // of a file's name, in small letters
    decltype(&readModel) read;
    decltype(&readMaterialsAgain) readMaterials;
};
constexpr Format kFormats[] = {{".obj", readObj, readObjMaterials}};

const Format *formatOf(const std::string &path) {
    std::string name = path;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const Format &format : kFormats)
        if (name.ends_with(format.ending)) return &format;
    return nullptr;
}

// A file with another ending is read as OBJ.
const Format &formatToRead(const std::string &path) {
    const Format *format = formatOf(path);
    return format ? *format : kFormats[0];
}

} // namespace

bool isModel(const std::string &path) { return formatOf(path) != nullptr; }

Mesh readModel(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    return formatToRead(path).read(path, settings, notes);
}

std::vector<MeshMaterial> readMaterialsAgain(const std::string &path, const MaterialNames &names,
                                             const std::vector<MaterialChange> &changes,
                                             std::vector<std::string> &notes) {
    return formatToRead(path).readMaterials(path, names, changes, notes);
}

} // namespace odraz::radiosity

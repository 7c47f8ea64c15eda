// A glTF 2.0 file: its JSON as tinygltf reads it, its buffers, and pictures. tinygltf trusts what damaged
// files say, so all that leads from one part of the file to another is checked here.
#pragma once

#include "tools/radiosity/read/mesh.h"

#include <nlohmann/json.hpp>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_JSON
#include <tiny_gltf.h>

namespace odraz::radiosity {

// Whether a file that begins like this is read as glTF: as .glb, or as JSON.
bool isGltf(std::string_view start);

// Whether a URI is none of a file beside the model, but http:// or another.
bool hasScheme(const std::string &uri);

// All functions throw Refused, without the file's name.
class GltfFile {
public:
    explicit GltfFile(const std::string &path);

    tinygltf::Model model; // without buffers and images

    // An index of one of the model's lists, checked. `what` names the list.
    template <class T> static const T &at(const std::vector<T> &list, int index, const char *what) {
        if (index < 0 || (size_t)index >= list.size()) refuseIndex(what, index);
        return list[(size_t)index];
    }

    // The components of an accessor, item by item; of normalised ones -1 .. 1. `type` is TINYGLTF_TYPE_VEC3
    // or another.
    std::vector<double> numbers(int accessor, int type) const;
    // The picture of a texture. Without a path if it has none in a format that is read; one whose URI has a
    // scheme has that as its path.
    MeshPicture picture(int texture);

private:
    [[noreturn]] static void refuseIndex(const char *what, int index);

    std::string path;
    std::vector<std::string> buffers;
    nlohmann::json images;
    std::map<int, MeshPicture> pictures;

    void readJson(std::string_view text, std::string_view binary);
    void readBuffers(const nlohmann::json &list, std::string_view binary);
    std::string_view view(int number) const;
    void copy(int view, size_t offset, int component, bool normalised, size_t wide, size_t count,
              std::vector<double> &to) const;
};

// Whether an extension, such as KHR_lights_punctual, is read.
bool isExtensionRead(const std::string &name);

// The JSON, not nested deeply, with each property that is read of its type: tinygltf skips an optional one of
// a wrong type, or truncates it. Extras and extensions that are not read may be anything. Throws Refused,
// without the file's name.
nlohmann::json parseGltf(std::string_view text);

} // namespace odraz::radiosity

// A glTF 2.0 file: its JSON, which tinygltf reads, its buffers and its pictures. tinygltf does not check
// indices and sizes, so every reference from one part of the file to another is checked here.
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

// Whether a file with this beginning is read as glTF: .glb or JSON.
bool isGltf(std::string_view start);

// Whether a URI has a scheme such as http://. Otherwise it names a file next to the model.
bool hasScheme(const std::string &uri);

// All functions throw Refused; the message lacks the file's name.
class GltfFile {
public:
    explicit GltfFile(const std::string &path);

    tinygltf::Model model; // without buffers and images

    // Returns the item at an index, or throws Refused. `what` names the list.
    template <class T> static const T &at(const std::vector<T> &list, int index, const char *what) {
        if (index < 0 || (size_t)index >= list.size()) refuseIndex(what, index);
        return list[(size_t)index];
    }

    // The components of all items of an accessor of `type` TINYGLTF_TYPE_..; normalised ones are -1 .. 1.
    std::vector<double> numbers(int accessor, int type) const;
    // A texture's picture. Its path is empty if the format is not read. A URI with a scheme becomes the path.
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
    void copy(int view, size_t offset, int component, bool normalised, size_t width, size_t count,
              std::vector<double> &to) const;
};

// Whether an extension, such as KHR_lights_punctual, is read.
bool isExtensionRead(const std::string &name);

// Parses the JSON and checks its depth and the type of each property that is read: tinygltf skips or
// truncates optional properties of a wrong type. Throws Refused, without the file's name.
nlohmann::json parseGltf(std::string_view text);

} // namespace odraz::radiosity

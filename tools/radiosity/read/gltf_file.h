// A glTF 2.0 file: its JSON, its buffers and its pictures. Every reference from one part of the file to
// another is checked where it is followed.
#pragma once

#include "tools/radiosity/read/gltf_json.h"
#include "tools/radiosity/read/mesh.h"

#include <map>

namespace odraz::radiosity {

// Whether a file with this beginning is read as glTF: .glb or JSON.
bool isGltf(std::string_view start);

// Whether a URI has a scheme such as http://. Otherwise it names a file next to the model.
bool hasScheme(const std::string &uri);

// All functions throw Refused; the message lacks the file's name.
class GltfFile {
public:
    explicit GltfFile(const std::string &path);

    json root; // has all lists of objects; those that the file lacks are null

    // The components of all items of an accessor of this type, such as "VEC3"; normalised ones are -1 .. 1.
    std::vector<double> numbers(int accessor, const std::string &type) const;
    // A texture's picture. Its path is empty if the format is not read. A URI with a scheme becomes the path.
    MeshPicture picture(int texture);

private:
    std::string path;
    std::vector<std::string> buffers;
    std::map<int, MeshPicture> pictures;

    void readJson(std::string_view text, std::string_view binary);
    void readBuffers(std::string_view binary);
    std::string_view view(int number) const;
    // Appends `count` items of `width` components each.
    void copy(int view, size_t offset, int component, bool normalised, size_t width, size_t count,
              std::vector<double> &to) const;
};

} // namespace odraz::radiosity

// Reads a model from strings, for tests of the readers, and generated models, for tests of radiosity.
#pragma once

#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/generate.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

using Lines = std::vector<std::string>;
using Colour = std::array<float, 3>;

// The mesh and its notes, or the error. The temporary folder's name is removed from both.
struct ReadModel {
    Mesh mesh;
    pictures::Picture picture; // the first material's
    Lines notes;
    std::string error;

    // Reads `text` as a file called `name`. If `content` is not empty, it is a second file, called `other`.
    explicit ReadModel(const std::string &text, const std::string &name = "m.gltf",
                       const ReadSettings &settings = {}, const std::string &other = "",
                       const std::string &content = "") {
        common::TemporaryFolder folder;
        common::writeWhole(folder / name, text);
        if (!content.empty()) common::writeWhole(folder / other, content);
        try {
            mesh = readModel(folder / name, settings, notes);
            if (!mesh.materials[0].picture.path.empty()) picture = mesh.materials[0].picture.read();
        } catch (const common::Refused &e) {
            error = e.what();
        }
        notes.push_back(error);
        const std::string own = folder / "";
        for (std::string &line : notes)
            for (size_t at; (at = line.find(own)) != std::string::npos;) line.erase(at, own.size());
        error = notes.back();
        notes.pop_back();
    }
    double area() const { return areaOf(mesh); }
};

// Writes a model of generateObj() to a file and reads it.
inline Mesh generatedMesh(const std::string &kind) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "model.mtl", generateMtl());
    common::writeWhole(folder / "model.obj", "mtllib model.mtl\n" + generateObj(kind, 0));
    Lines notes;
    return readModel(folder / "model.obj", {}, notes);
}

} // namespace odraz::radiosity

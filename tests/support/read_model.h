// A model that is read from a text.
#pragma once

#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

using Lines = std::vector<std::string>;

// The mesh with its notes, or the error; both without the name of the folder.
struct ReadModel {
    Mesh mesh;
    pictures::Picture picture; // the first material's
    Lines notes;
    std::string error;

    // `other`: a file beside it, if it has any content.
    ReadModel(const std::string &text, const std::string &name, const ReadSettings &settings,
              const std::string &other, const std::string &content) {
        common::TemporaryFolder folder;
        common::writeWhole(folder / name, text);
        if (!content.empty()) common::writeWhole(folder / other, content);
        try {
            mesh = readModel(folder / name, settings, notes);
            if (!mesh.materials[0].picture.path.empty()) picture = mesh.materials[0].picture.read();
        } catch (const common::Refused &e) {
            error = e.what();
        }
        auto cut = [&](std::string &line) {
            const std::string own = folder / "";
            for (size_t at; (at = line.find(own)) != std::string::npos;) line.erase(at, own.size());
        };
        cut(error);
        for (std::string &note : notes) cut(note);
    }
    double area() const { return areaOf(mesh); }
};

} // namespace odraz::radiosity

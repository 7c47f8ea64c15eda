// Edits of the film's tracks: from an editor of GNU Rocket, and manual ones.
#pragma once

#include "maker/rocket/client.h"
#include "maker/stage.h"
#include "maker/tracks.h"

#include <memory>

namespace odraz::maker {

class Edits {
public:
    // `show`: the folder of the film's content with its key files. `host`: where the editor is; empty: none.
    Edits(const Stage &stage, std::string show, std::string host = "", int port = rocket::kPort);

    // Reads the tracks of a new film. Call this whenever the film has been replaced.
    void renew();

    struct Requests {              // from the editor
        std::optional<double> row; // to show
        std::optional<bool> pause;
        bool save = false;
        std::string message; // a line when the connection changes, else empty
    };
    // Call this once per picture. Sends `row` of the film to the editor, and takes its keys. `now`: seconds.
    Requests update(double now, double row);

    // Sets a key with the eye and target of `camera`, or removes the key if `camera` is null. Returns its
    // row, which is `row` rounded (see Tracks::rowOfView). `message`: what was done, or why not.
    uint32_t setView(double row, const CameraKey *camera, std::string &message);
    // Undo or redo one manual edit, or save all edits. These return what was done, or why not.
    std::string undo();
    std::string redo();
    std::string save();
    int unsaved() const { return tracks.unsaved(); } // number of tables

    // Writes all tracks as a document of GNU Rocket. Returns what was written. Throws std::runtime_error.
    std::string writeDocument(const std::string &file);

private:
    const Stage &stage;
    std::string host;
    int port;
    Tracks tracks;
    std::unique_ptr<rocket::Client> client;
    bool connected = false;
    double since = 0; // when `connected` last changed
    std::string problem;
    uint64_t version = 0;
};

} // namespace odraz::maker

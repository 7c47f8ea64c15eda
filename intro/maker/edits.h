// Edits the film's tracks: from an editor of GNU Rocket, and by hand.
#pragma once

#include "maker/rocket/client.h"
#include "maker/stage.h"
#include "maker/tracks.h"

#include <memory>

namespace odraz::maker {

class Edits {
public:
    // Without a host there is no editor, and tracks are edited by hand alone.
    // `show`: the folder of the film's content, which files of keys are read and written.
    Edits(const Stage &stage, std::string show, std::string host = "", int port = rocket::kPort);

    // There is a new film: finds its tracks.
    void renew();

    struct Requests {              // of the editor
        std::optional<double> row; // to which it went
        std::optional<bool> pause;
        bool save = false;
        std::string message; // that it came or went, as a line; else empty
    };
    // Once a picture, at a row of the film, which the editor gets to know; its keys are taken over. `now`:
    // seconds of any clock.
    Requests update(double now, double row);

    // Sets a key for the eye and the target of a view, on the row next to one of the film, which it returns;
    // or removes it, where `camera` is null. `message`: what was done, or why not.
    uint32_t setView(double row, const CameraKey *camera, std::string &message);
    // One step that was done by hand. These return what was done, or why not.
    std::string undo();
    std::string redo();
    std::string save();                              // all that was edited
    int unsaved() const { return tracks.unsaved(); } // tables

    // Writes all tracks for an editor to open. Throws std::runtime_error; returns what was written.
    std::string writeDocument(const std::string &file);

private:
    const Stage &stage;
    std::string host;
    int port;
    Tracks tracks;
    std::unique_ptr<rocket::Client> client;
    bool connected = false;
    double since = 0; // when it connected
    std::string problem;
    uint64_t version = 0;
};

} // namespace odraz::maker

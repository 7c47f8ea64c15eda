// Edits the film's tracks: from an editor of GNU Rocket, and by hand.
#pragma once

#include "maker/rocket/client.h"
#include "maker/stage.h"
#include "maker/tracks.h"

#include <memory>

namespace odraz {

class Remote {
public:
    // Without a host there is no editor, and tracks are edited by hand alone.
    // `show`: the folder of the film's content, which edits are written to.
    explicit Remote(std::string show, std::string host = "", int port = rocket::kPort);

    // There is a new film: its tracks are found when they are needed.
    void renew() { found = false; }

    struct Told {
        std::optional<double> row; // where the editor is now
        std::optional<bool> pause;
        bool save = false;
        std::string news; // that it came or went, as a line; else empty
    };
    // Once a picture, at a row of the film: tells the editor, and does what it told. `now`: seconds of any
    // clock.
    Told update(const Stage &stage, double now, double row);

    // Sets a key for the eye and the target of a view, on the row next to one of the film, which it returns;
    // or removes it. `news`: what was done, or why not.
    uint32_t setView(const Stage &stage, double row, const CameraKey &camera, std::string &news);
    uint32_t removeView(const Stage &stage, double row, std::string &news);
    void undo(const Stage &stage, std::string &news); // one step that was done by hand
    void redo(const Stage &stage, std::string &news);
    // Writes all that was edited to the sources. Returns what was not written, or nothing.
    std::string save(const Stage &stage, std::string &news);
    int unsaved() const { return tracks.unsaved(); } // tables

    // Writes all tracks for an editor to open. Returns what went wrong, or nothing; `news` is what was
    // written.
    std::string writeDocument(const Stage &stage, const std::string &file, std::string &news);

private:
    void find(const Stage &stage);

    std::string host;
    int port;
    Tracks tracks;
    bool found = false;
    std::unique_ptr<rocket::Client> client;
    bool connected = false;
    double since = 0; // when it connected
    std::string problem;
    uint64_t version = 0;
};

} // namespace odraz

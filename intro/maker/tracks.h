// The film's tracks under the names that GNU Rocket shows, with all edits of them.
//
// A camera's path is eight tracks, such as "hall.camera.descent:eye.x", named after the scene that it shows
// and the table in film.keys (kDescent). A table of Key is one track, such as "hall:exposure", named after
// its file and its name there. Rows count from the film's start.
//
// Rocket has no Hermite curves: a camera's path keeps its own, and Rocket's documents say "smooth". Rocket
// has no fractional and no negative rows: a key is sent on the nearest row, or left out if that is negative.
// In the film it keeps its row.
#pragma once

#include "maker/keys/key_tables.h"
#include "maker/live.h"
#include "maker/rocket/client.h"

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace odraz::maker {

inline constexpr size_t kChannels = 8; // the numbers of a camera: eye, target, roll, field of view

class Tracks {
public:
    // `show`: the folder of the film's content, whose key files are read and written.
    explicit Tracks(std::string show = "") : files(std::move(show)) {}

    // Lists the tracks of a film that was loaded, and reads its files again (see KeyTables::read).
    void readFilm(const Live &live);

    const std::vector<std::string> &names() const { return allNames; }
    // The track that is shown, as far as Rocket can express it.
    rocket::Track track(size_t i) const;

    // The number of keys for which Rocket has no row (see above).
    int offRows() const;

    // Takes over an editor's version of a track. If it has no keys, the film's own are shown.
    void takeFromEditor(size_t i, const rocket::Track &keys);
    // Edits the camera path that is shown at a row of the film: sets eye and target of a key there, or
    // removes the key if `camera` is null. The edit holds until an editor changes that key. Returns why it
    // failed, or an empty string. The row must be a result of rowOfView().
    std::string setView(uint32_t row, const CameraKey *camera);
    // Describes a row of rowOfView() in its scene and in the film. Warns if another key is within a beat.
    std::string rowInWords(uint32_t row) const;
    // Rounds a row of the film to the nearest whole row, or down if the nearest shows another path (a cut).
    uint32_t rowOfView(double row) const;
    bool undo() { return files.undo(); } // one manual edit
    bool redo() { return files.redo(); }
    // Writes all edits to the files. Returns what was not written, and why. `message`: what was written.
    std::string save(std::string &message);
    // The number of tables with unsaved edits: manual ones only, or all.
    int unsavedByHand() const { return files.edited(); }
    int unsaved() const { return files.edited() + unsavedByEditor; }

    // Applies all edits to the film, from the next picture on.
    void show();

private:
    struct FilmTable {
        KeyTable *live;
        int scene;
        double shift;      // the film's row, minus the table's
        int file;          // its index in `files`
        std::string name;  // its track's name, or its tracks' common part up to the colon
        size_t firstTrack; // index of its only track, or of the first of kChannels

        double filmRow(float row) const { return std::round((double)row + shift); } // the nearest one
    };
    struct Edit {
        rocket::Track editor;
        std::set<uint32_t> byHand; // rows where a later manual edit replaces the editor's key
    };
    int tableAt(double row) const; // index of the camera's table at a row; -1: none
    const std::vector<KeyNumbers> &ownKeys(const FilmTable &table) const; // with manual edits only
    std::vector<Key> editedChannel(const FilmTable &table, size_t channel) const;
    std::vector<KeyNumbers> editedKeys(const FilmTable &table) const; // with all edits

    const Live *live = nullptr;
    std::vector<ShotInfo> shots;
    std::vector<FilmTable> tables;
    std::vector<size_t> tableOf; // by track
    std::vector<std::string> allNames;
    std::map<std::string, Edit> edits; // from the editor, by track name
    KeyTables files;
    int unsavedByEditor = 0;
};

} // namespace odraz::maker

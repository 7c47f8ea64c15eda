// Every track of the film, under a name, as GNU Rocket knows tracks; and what was edited of them.
//
// A camera's path is eight tracks, "hall.camera.beams:eye.x", after the scene that is shown and the table in
// film.keys (kBeams); a table of Key is one, "hall:exposure", after its file and its name there. Rows are
// those of the film.
//
// Rocket has no Hermite curves: a camera's path keeps its own, whatever interpolation its keys are said to
// have (smooth). It has no rows before 0 nor between two others: keys there stay the film's; in Rocket they
// are on the nearest row.
#pragma once

#include "maker/keys/key_tables.h"
#include "maker/live.h"
#include "maker/rocket/track.h"

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace odraz::maker {

inline constexpr size_t kChannels = 8; // the numbers of a camera: eye, target, roll, field of view

class Tracks {
public:
    // `show`: the folder of the film's content, whose files of keys are read and written.
    explicit Tracks(std::string show = "") : files(std::move(show)) {}

    // The tracks of a film that was loaded, and reads its files again (see KeyTables::read).
    void find(const Live &live);

    const std::vector<std::string> &names() const { return allNames; }
    // What is shown, as far as Rocket has a way to store it.
    rocket::Track track(size_t i) const;

    // How many keys of the film Rocket has no row for: see above.
    int offRows() const;

    // What an editor has of a track; without keys it is the film's own that is shown.
    void takeFromEditor(size_t i, const rocket::Track &keys);
    // By hand, of the camera's path that is shown at a row of the film: sets eye and target there (the rest
    // as it is), or removes the key where `camera` is null. It is in force until an editor changes that key.
    // Returns why not, or nothing. The row must be one that rowOfView() gave.
    std::string setView(uint32_t row, const CameraKey *camera);
    // That row as a text, in rows of its scene and of the film; with a warning if another key is within a
    // beat: the path may swing.
    std::string rowInWords(uint32_t row) const;
    // The row next to one of the film on which the same path is shown: beside a cut not always the nearest.
    uint32_t rowOfView(double row) const;
    bool undo() { return files.undo(); } // of what was done by hand
    bool redo() { return files.redo(); }
    // Writes all that was edited, here and in an editor, to the files. Returns what was not, and why.
    // `message`: what was written.
    std::string save(std::string &message);
    // How many tables were edited and are not saved: by hand, and by an editor.
    int unsavedByHand() const { return files.edited(); }
    int unsaved() const { return files.edited() + unsavedByEditor; }

    // From the next picture on, the film is as it was edited.
    void show();

private:
    struct Table {
        KeyTable *live;
        int scene;
        double shift;      // the film's row, minus the table's
        int file;          // its index in `files`
        std::string name;  // of its track, or of all of them up to the colon
        size_t firstTrack; // of 1, or of kChannels

        double filmRow(float row) const { return std::round((double)row + shift); } // the nearest one
    };
    struct Edit {
        rocket::Track editor;
        std::set<uint32_t> byHand; // rows on which the editor's key is not in force
    };
    int tableAt(double row) const;                                // of the camera; -1: none
    const std::vector<KeyNumbers> &own(const Table &table) const; // without the editor
    std::vector<Key> edited(const Table &table, size_t channel) const;
    std::vector<KeyNumbers> contents(const Table &table) const; // what is shown, with all that was edited

    const Live *live = nullptr;
    std::vector<ShotInfo> shots;
    std::vector<Table> tables;
    std::vector<size_t> tableOf; // of each track
    std::vector<std::string> allNames;
    std::map<std::string, Edit> edits; // of the editor, by track
    KeyTables files;
    int unsavedByEditor = 0;
};

} // namespace odraz::maker

// Every track of the film, under a name, as GNU Rocket knows tracks; and what was edited of them.
//
// A camera's path is eight tracks, "hall.camera.beams:eye.x", after the scene that is shown and the table in
// the source (kBeams); a table of Key is one, "hall:exposure". Rows are those of the film. A scene's table
// may be read more than once, at different rows; its rows count from where it is read first.
//
// Rocket has no Hermite curves: a camera's path keeps its own, whatever interpolation its keys are said to
// have (smooth). It has no rows before 0 nor between two others: keys there stay the film's; in Rocket they
// are on the nearest row.
#pragma once

#include "maker/hand_edits.h"
#include "maker/live.h"
#include "maker/rocket/track.h"
#include "maker/symbols.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace odraz {

class Tracks {
public:
    // `show`: the folder of the film's content, which hand edits are written to.
    explicit Tracks(std::string show = "") : hand(std::move(show)) {}

    // The tracks of a film that was loaded. What was edited stays, by name; it must be shown() again.
    void find(const Live &live, Intro &intro, const std::vector<Symbol> &symbols);

    const std::vector<std::string> &names() const { return allNames; }
    // What is shown, as Rocket can say it.
    rocket::Track track(size_t i) const;

    // How many keys of the film Rocket has no row for: see above.
    int offRows() const;

    // What an editor has of a track; without keys it is the film's own that is shown.
    void takeFromEditor(size_t i, const rocket::Track &keys);
    // By hand, of the camera's path that is shown at a row of the film: sets eye and target there (the rest
    // as it is), or removes the key. It is in force until an editor changes that key. Returns why not, or
    // nothing. The row must be one that rowOfView() gave.
    std::string setView(uint32_t row, const CameraKey &camera);
    std::string removeView(uint32_t row);
    // That row in words, as the source of its camera's path counts and as the film does; and whether another
    // key stands so near that the path may swing.
    std::string rowInWords(uint32_t row) const;
    // The row next to one of the film on which the same path is shown: beside a cut not always the nearest.
    uint32_t rowOfView(double row) const;
    bool undo() { return hand.undo(); } // of what was done by hand
    bool redo() { return hand.redo(); }
    // Writes all that was edited, here and in an editor, to the sources. Returns what was not, and why.
    std::string save(std::string &news);
    // How many tables were edited and are not saved: by hand, and by an editor.
    int unsavedByHand() const { return hand.unsaved(); }
    int unsaved() const { return hand.unsaved() + unsavedByEditor; }

    // From the next picture on, the film is as it was edited.
    void show();

private:
    struct Edit {
        rocket::Track editor;
        std::set<uint32_t> byHand; // rows on which the editor's key is not in force
        bool none() const { return editor.empty(); }
    };
    struct One {
        size_t table;
        int channel; // of a camera; else 0
    };
    size_t firstOf(size_t table) const; // its first track
    int cameraAt(double row) const;     // the first of its tracks; -1
    std::string setByHand(uint32_t row, const CameraKey *camera);
    std::vector<Key> own(const One &one) const;                  // as the table has them
    std::vector<maker::KeyNumbers> contents(size_t table) const; // what is shown, with all that was edited
    bool edited(const Table &t, size_t table) const;
    std::vector<Key> edited(size_t i) const;
    double filmRow(const Table &t, float row) const { return (double)row + (double)t.shift; }
    bool onRow(const Table &t, const Key &key, uint32_t row) const;

    const Live *live = nullptr;
    std::vector<Table> tables;
    std::vector<One> all;
    std::vector<std::string> allNames;
    std::map<std::string, Edit> edits; // of the editor
    HandEdits hand;
    int unsavedByEditor = 0;

    // What the film reads
    std::vector<Replaced> replaced;
    std::vector<std::vector<Key>> keys;
    std::vector<std::vector<CameraKey>> poses;
};

} // namespace odraz

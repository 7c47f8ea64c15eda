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

#include "maker/live.h"
#include "maker/rocket/track.h"
#include "maker/symbols.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace odraz {

class Tracks {
public:
    // The tracks of a film that was loaded. What was edited stays, by name; it must be shown() again.
    void find(const Live &live, Intro &intro, const std::vector<Symbol> &symbols);

    const std::vector<std::string> &names() const { return allNames; }
    // What is shown, as Rocket can say it.
    rocket::Track track(size_t i) const;

    // How many keys of the film Rocket has no row for: see above.
    int offRows() const;

    // What an editor has of a track; without keys it is the film's own that is shown.
    void takeFromEditor(size_t i, const rocket::Track &keys);
    // By hand: sets a key, or removes the one on that row. It is in force until an editor changes that key.
    void set(size_t i, uint32_t row, std::optional<float> value);

    // The first of the eight tracks of the camera's path that is shown at a row of the film; none: -1.
    int cameraAt(double row) const;

    // From the next picture on, the film is as it was edited.
    void show();

private:
    struct Edit {
        rocket::Track editor;
        std::map<uint32_t, std::optional<float>> hand;
        bool none() const { return editor.empty() && hand.empty(); }
    };
    struct One {
        size_t table;
        int channel; // of a camera; else 0
    };
    std::vector<Key> own(const One &one) const; // as the table has them
    std::vector<Key> edited(size_t i) const;
    double filmRow(const Table &t, float row) const { return (double)row + (double)t.shift; }
    bool onRow(const Table &t, const Key &key, uint32_t row) const;

    const Live *live = nullptr;
    std::vector<Table> tables;
    std::vector<One> all;
    std::vector<std::string> allNames;
    std::map<std::string, Edit> edits;

    // What the film reads
    std::vector<Replaced> replaced;
    std::vector<std::vector<Key>> keys;
    std::vector<std::vector<CameraKey>> poses;
};

} // namespace odraz

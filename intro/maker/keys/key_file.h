// A file of keys (timeline/keys.h), read line by line and changed line by line: comments stay, and so does
// what did not change.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

#include <map>
#include <string>
#include <vector>

namespace odraz::maker {

// The numbers of a key in their order: row, value, interpolation; or row, eye, target, roll, field of view.
using KeyNumbers = std::vector<float>;
KeyNumbers numbersOf(const Key &key);
KeyNumbers numbersOf(const CameraKey &key);
Key keyOf(const KeyNumbers &numbers);
CameraKey cameraKeyOf(const KeyNumbers &numbers);

using Events = std::map<std::string, float>; // rows by name, "kLampLights"

class KeyFile {
public:
    struct Table {
        std::string name; // "kSink"
        bool camera;
        int bits = 24; // of a path's numbers
        std::vector<KeyNumbers> keys = {};

        KeyNumbers rounded(const KeyNumbers &key) const; // as the program has it
    };

    // Parses a text. Throws std::runtime_error: "NAME:LINE: what is wrong".
    KeyFile(const std::string &name, const std::string &text, const Events &events);

    const std::vector<Table> &tables() const { return all; }
    // Replaces a table's keys; they are in ascending order of rows, and at least one. A key that moves keeps
    // its comment, and counts from the event that it counted from. The comment of a key that goes stays.
    void set(size_t table, const std::vector<KeyNumbers> &keys);
    std::string text() const;

private:
    struct Line {
        std::string text;
        size_t table = SIZE_MAX; // that it is a key of
        KeyNumbers numbers = {};
        std::string event = {}, comment = {}; // that its row counts from; with its slashes
    };
    void write(Line &line, const KeyNumbers &numbers) const;

    Events events;
    std::vector<Line> lines;
    std::vector<Table> all;
};

// A number as files have it: the shortest that is read as the same float.
std::string written(float number);

// A key as a line of a file.
std::string writtenKey(const KeyNumbers &key, const std::string &row);

} // namespace odraz::maker

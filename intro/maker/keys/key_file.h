// A key file (timeline/keys.h), read and changed line by line: comments and unchanged lines stay as they are.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

#include <map>
#include <string>
#include <vector>

namespace odraz::maker {

// A key's numbers in order: row, value, interpolation; for cameras row, eye, target, roll, field of view.
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
        int bits = 24; // significant bits of a path's numbers
        std::vector<KeyNumbers> keys = {};

        KeyNumbers rounded(const KeyNumbers &key) const; // as the program stores it
    };

    // Parses a text. Throws std::runtime_error: "NAME:LINE: what is wrong".
    KeyFile(const std::string &name, const std::string &text, const Events &events);

    const std::vector<Table> &tables() const { return all; }
    // Replaces a table's keys by one or more, in ascending order of rows. A key that moves keeps its comment
    // and the event that its row counts from. The comment of a removed key stays.
    void set(size_t table, const std::vector<KeyNumbers> &keys);
    std::string text() const;

private:
    struct Line {
        std::string text;
        size_t table = SIZE_MAX; // the table whose key is on the line; SIZE_MAX: no key
        KeyNumbers numbers = {};
        std::string event = {};   // the event that its row counts from, if any
        std::string comment = {}; // with its slashes
    };
    void write(Line &line, const KeyNumbers &numbers) const;

    Events events;
    std::vector<Line> lines;
    std::vector<Table> all;
};

// Returns a number as text for a file: the shortest text that reads as the same float.
std::string written(float number);

// Returns a key as a line for a file. `row`: the text of its row.
std::string writtenKey(const KeyNumbers &key, const std::string &row);

} // namespace odraz::maker

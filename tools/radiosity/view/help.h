// The keys of `view`, defined once: for the line printed at the start, and for the help in the window.
#pragma once

#include "tools/picture/picture.h"

#include <span>
#include <string>

namespace odraz::radiosity {

struct ViewKey {
    const char *keys, *does;
};
inline constexpr ViewKey kViewKeys[] = {
    {"W A S D", "fly ahead, left, back, right"},
    {"Q E", "fly down, up"},
    {"Shift", "flies faster"},
    {"mouse", "with its left button looks"},
    {"wheel", "exposes"},
    {"1", "patches"},
    {"2", "elements"},
    {"3", "wireframe"},
    {"4", "hemicube under the pointer"},
    {"B", "backs"},
    {"T", "tone"},
    {"C", "camera line"},
    {"R", "back to the start"},
    {"H F1", "this help"},
    {"Esc", "ends"},
};
inline constexpr ViewKey kRoomKeys[] = {
    {"W A S D", "fly ahead, left, back, right"},
    {"Q E", "fly down, up"},
    {"Shift", "flies faster"},
    {"mouse", "left button looks, right one turns the sky"},
    {"wheel", "exposes"},
    {"1 .. 9 0", "lamps; with Shift 11 to 16"},
    {"[ ]", "bands"},
    {"P", "exact rows, or clusters"},
    {"- =", "axes of the clusters"},
    {", .", "half and twice as many clusters"},
    {"F2 .. F5", "patches, elements, wireframe, hemicube"},
    {"B", "backs"},
    {"T", "tone"},
    {"C", "camera line"},
    {"R", "back to the start"},
    {"H F1", "this help"},
    {"Esc", "ends"},
};

// The keys for a solution, or for a room that is relit.
inline std::span<const ViewKey> viewKeys(bool room) {
    return room ? std::span<const ViewKey>(kRoomKeys) : std::span<const ViewKey>(kViewKeys);
}

// The keys in one line.
std::string viewKeysLine(std::span<const ViewKey> keys);

// The keys on a dark ground, one line each; the picture is at most this large.
pictures::Image viewHelp(std::span<const ViewKey> keys, int width, int height);

} // namespace odraz::radiosity

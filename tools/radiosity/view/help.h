// The keys of `view`, defined once: for the line printed at the start, and for the help in the window.
#pragma once

#include "tools/picture/picture.h"

#include <string>

namespace odraz {

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

// The keys in one line.
std::string viewKeysLine();

// The keys on a dark ground, one line each; the picture is at most this large.
Picture viewHelp(int width, int height);

} // namespace odraz

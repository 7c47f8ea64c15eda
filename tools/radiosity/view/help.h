// The keys of `view`, defined once: for the line printed at the start, and for the help in the window.
#pragma once

#include "tools/picture/picture.h"

#include <span>
#include <string>
#include <vector>

namespace odraz::radiosity {

struct ViewKey {
    const char *keys, *does;
};
// The keys for a solution, or for a room that is relit.
std::vector<ViewKey> viewKeys(bool room);

// The keys in one line.
std::string viewKeysLine(std::span<const ViewKey> keys);

// The keys on a dark ground, one line each; the picture is at most this large.
pictures::Image viewHelp(std::span<const ViewKey> keys, int width, int height);

} // namespace odraz::radiosity

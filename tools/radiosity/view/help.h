// The keys of `view`, for the text printed at the start and for the help in the window.
#pragma once

#include "tools/picture/picture.h"

#include <span>
#include <string>
#include <vector>

namespace odraz::radiosity {

struct ViewKey {
    const char *keys, *does;
};
// The keys for a solution, or with `room` for a relit room.
std::vector<ViewKey> viewKeys(bool room);

// The keys, one on a line.
std::string viewKeysText(std::span<const ViewKey> keys);

// A picture of the keys on a dark ground, one on a line, of at most width x height pixels.
pictures::Image viewHelp(std::span<const ViewKey> keys, int width, int height);

} // namespace odraz::radiosity

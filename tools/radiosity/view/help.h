// The keys of `view`, for the text that it prints at the start and for the help in its window.
#pragma once

#include "tools/picture/picture.h"

#include <span>
#include <string>
#include <vector>

namespace odraz::radiosity {

struct ViewKey {
    const char *keys, *does;
};
// The keys for a solution, or for a relit room (`room`).
std::vector<ViewKey> viewKeys(bool room);

// The keys as text, one per line.
std::string viewKeysText(std::span<const ViewKey> keys);

// A picture of the keys on a dark background, one per line, with at most width x height pixels.
pictures::Image viewHelp(std::span<const ViewKey> keys, int width, int height);

} // namespace odraz::radiosity

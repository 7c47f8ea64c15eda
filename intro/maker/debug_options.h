// The options that odraz-debug has in addition to the film's.
#pragma once

#include <string>

namespace odraz::maker {

struct DebugOptions {
    const char *shown = nullptr;  // --shown FILE
    const char *tracks = nullptr; // --tracks FILE
    std::string host;             // --rocket [HOST[:PORT]]; empty: not given
    int port = 0;
};

// Removes these options from the arguments, and leaves the film's. Returns an error line, or an empty string.
std::string takeOptions(int &argc, char **argv, DebugOptions &to);

} // namespace odraz::maker

// The options that odraz-debug has and the film has not.
#pragma once

#include <string>

namespace odraz::maker {

struct DebugOptions {
    const char *shown = nullptr;  // --shown FILE
    const char *tracks = nullptr; // --tracks FILE
    std::string host;             // --rocket [HOST[:PORT]]; empty: it was not given
    int port = 0;
};

// Takes them out of the arguments, which are then those of the film. Returns what is wrong, or nothing.
std::string takeOptions(int &argc, char **argv, DebugOptions &to);

} // namespace odraz::maker

// The command line of Windows, as main gets it elsewhere.
#pragma once

namespace odraz {

struct Arguments {
    long count; // of values, without the null at the end
    char *values[512];
};

// In UTF-8, split as Windows programs do: at blanks that are not quoted. What is beyond the last of the
// values is left out.
Arguments &commandLine();

} // namespace odraz

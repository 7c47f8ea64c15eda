// The command line of Windows, split into the arguments that main() gets on other systems.
#pragma once

namespace odraz {

struct CommandLine {
    long count; // of values, without the null at the end
    char *values[512];
};

// In UTF-8, split as Windows programs do: at blanks that are not quoted. CommandLine for which `values` has
// no room are left out.
CommandLine &commandLine();

} // namespace odraz

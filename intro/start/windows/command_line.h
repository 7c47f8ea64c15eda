// Splits the command line of Windows into the arguments that main() gets on other systems.
#pragma once

namespace odraz {

struct Arguments {
    long count; // number of values, without the null at the end
    char *values[512];
};

// Returns the arguments in UTF-8, split as Windows programs do: at blanks that are not quoted. Arguments
// beyond the size of `values` are left out.
Arguments &arguments();

} // namespace odraz

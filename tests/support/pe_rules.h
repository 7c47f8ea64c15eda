// What the loaders of Windows 10 and 11 ask of an executable, as far as ours could fail it: Wine takes much
// more. From Microsoft's "PE Format" and what is known of the kernel's and ntdll's checks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Empty, or the first rule that a file breaks.
std::string brokenPeRule(const std::vector<uint8_t> &file);

// "library: function function", in the file's order, separated by blanks.
std::string peImports(const std::vector<uint8_t> &file);

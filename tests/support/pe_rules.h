// The rules of Windows 10 and 11 for executables, as far as the packer's files could break them. Wine accepts
// much more. From Microsoft's "PE Format" and the known checks of the kernel and ntdll.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

// The first rule that a file breaks; empty if none.
std::string brokenPeRule(const std::vector<uint8_t> &file);

// "library: function function", in the file's order, separated by blanks.
std::string peImports(const std::vector<uint8_t> &file);

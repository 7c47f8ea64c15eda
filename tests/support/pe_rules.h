// Rules of Windows 10 and 11 for executables that the packer's files could break. Wine accepts much more.
// Sources: Microsoft's "PE Format", and known checks of the kernel and ntdll.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Returns the first rule that a file breaks; an empty string if it keeps all.
std::string brokenPeRule(const std::vector<uint8_t> &file);

// Returns "library: function function library: ...", in the file's order.
std::string peImports(const std::vector<uint8_t> &file);

// Tracks as a document that GNU Rocket's editors open.
#pragma once

#include "maker/rocket/track.h"

#include <string>
#include <vector>

namespace odraz::maker::rocket {

// XML, as the original editor writes it and emoon's reads it. `rows`: how many the document has. Names have
// no characters that XML knows (names of ours have letters, digits, '.', '-' and ':').
std::string document(const std::vector<std::string> &names, const std::vector<Track> &tracks, int rows);

} // namespace odraz::maker::rocket

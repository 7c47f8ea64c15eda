// What a link used, by GNU ld's map.
#pragma once

#include <string>
#include <vector>

namespace pack::linking {

struct Taken {
    std::vector<std::string> files;                           // all that were opened, in order
    std::vector<std::pair<std::string, std::string>> members; // archive and member, of those linked
};

// Empty if the text is not a map of GNU ld.
Taken readLinkerMap(const std::string &map);

} // namespace pack::linking

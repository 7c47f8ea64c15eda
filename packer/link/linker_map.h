// What a link took, by GNU ld's map of it.
#pragma once

#include <string>
#include <vector>

namespace pack::linking {

struct Taken {
    std::vector<std::string> files;                           // all that were opened, in their order
    std::vector<std::pair<std::string, std::string>> members; // archive and member, of those that were needed
};

// Of the text of a map; nothing in it if it is not GNU ld's.
Taken readLinkerMap(const std::string &map);

} // namespace pack::linking

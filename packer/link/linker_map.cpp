#include "packer/link/linker_map.h"

#include <algorithm>
#include <sstream>

namespace pack::linking {

namespace {

constexpr char kLoad[] = "LOAD ", kMembers[] = "Archive member included";

// "archive.a(member.o)   because.o (symbol)", where the second half may stand on the next line
void takeMember(const std::string &line, Taken &taken) {
    size_t end = line.find(".o)"), open = line.rfind('(', end);
    if (end == std::string::npos) { // the C library's members end in .oS; any ending is allowed
        end = line.find(')');
        open = line.rfind('(', end);
    } else
        end += 2;
    if (end == std::string::npos || open == std::string::npos) return;
    taken.members.emplace_back(line.substr(0, open), line.substr(open + 1, end - open - 1));
}

} // namespace

Taken readLinkerMap(const std::string &map) {
    Taken taken;
    std::istringstream lines(map);
    bool members = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(kMembers, 0) == 0)
            members = true;
        else if (members && !line.empty() && line[0] != ' ') {
            if (line.find('(') == std::string::npos || line.rfind("As-needed", 0) == 0)
                members = false; // the next heading
            else
                takeMember(line, taken);
        }
        if (line.rfind(kLoad, 0) != 0) continue;
        std::string file = line.substr(sizeof kLoad - 1);
        if (std::find(taken.files.begin(), taken.files.end(), file) == taken.files.end())
            taken.files.push_back(file);
    }
    return taken;
}

} // namespace pack::linking

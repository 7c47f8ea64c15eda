#include "maker/rocket/track.h"

#include <cstdio>

namespace odraz::maker::rocket {

std::string document(const std::vector<std::string> &names, const std::vector<Track> &tracks, int rows) {
    char line[160];
    std::snprintf(line, sizeof line, "<sync rows=\"%d\">\n\t<tracks startRow=\"0\" endRow=\"%d\">\n", rows,
                  rows - 1);
    std::string text = line;
    for (size_t i = 0; i < names.size(); ++i) {
        text += "\t\t<track name=\"" + names[i] + "\">\n";
        for (auto &[row, key] : tracks[i]) {
            std::snprintf(line, sizeof line, "\t\t\t<key row=\"%u\" value=\"%.9g\" interpolation=\"%d\"/>\n",
                          row, (double)key.value, (int)key.interpolation);
            text += line;
        }
        text += "\t\t</track>\n";
    }
    return text + "\t</tracks>\n\t<bookmarks/>\n</sync>\n";
}

} // namespace odraz::maker::rocket

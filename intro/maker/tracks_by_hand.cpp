// Manual edits of the camera path that is shown.
#include "maker/panel/content.h"
#include "maker/tracks.h"

#include <algorithm>
#include <cmath>

namespace odraz::maker {

int Tracks::tableAt(double row) const {
    const CameraKey *path = Content{0, shots, {}}.shotAt(row / kRowsPerSecond).path->keys;
    for (size_t i = 0; i < tables.size(); ++i)
        if (tables[i].live->poses == path) return (int)i;
    return -1;
}

uint32_t Tracks::rowOfView(double row) const {
    double nearest = std::fmax(std::round(row), 0);
    return (uint32_t)(tableAt(nearest) == tableAt(row) ? nearest : std::fmax(std::floor(row), 0));
}

std::string Tracks::setView(uint32_t row, const CameraKey *camera) {
    int at = tableAt(row);
    if (at < 0) return files.problems().empty() ? "its path is not in a key file" : files.problems();
    const FilmTable &t = tables[(size_t)at];
    std::vector<KeyNumbers> now = ownKeys(t);
    auto here = std::find_if(now.begin(), now.end(), [&](auto &k) { return t.filmRow(k[0]) == (double)row; });
    if (!camera) {
        if (here == now.end()) return "there is no key";
        if (now.size() == 1) return "it is the path's only key";
        now.erase(here);
    } else {
        if (here == now.end()) {
            std::vector<CameraKey> path;
            for (const KeyNumbers &k : now) path.push_back(cameraKeyOf(k));
            float tableRow = (float)((double)row - t.shift);
            here = now.insert(here, numbersOf(pose({path.data(), (int)path.size()}, tableRow)));
        }
        KeyNumbers view = numbersOf(*camera);
        std::copy_n(view.begin() + 1, 6, // eye and target
                    here->begin() + 1);
        // Round to millimetres and thousandths of a degree: finer steps are invisible, and hard to read
        for (size_t n = 1; n < here->size(); ++n) (*here)[n] = std::round((*here)[n] * 1000) / 1000;
    }
    for (size_t c = 0; c < kChannels; ++c) {
        auto edit = edits.find(allNames[t.firstTrack + c]);
        if (edit != edits.end()) edit->second.byHand.insert(row);
    }
    files.change(t.file, std::move(now));
    show();
    return "";
}

std::string Tracks::rowInWords(uint32_t row) const {
    constexpr double kNear = 4; // rows: one beat
    int at = tableAt(row);
    if (at < 0) return "row " + std::to_string(row);
    const FilmTable &t = tables[(size_t)at];
    double tableRow = (double)row - t.shift, nearest = kNear;
    for (const KeyNumbers &k : editedKeys(t))
        if (double distance = std::fabs((double)k[0] - tableRow); distance > 0.5)
            nearest = std::min(nearest, distance);
    std::string words = "row " + written((float)tableRow) + " of " + live->sceneName(t.scene);
    if (t.shift != 0) words += ", " + std::to_string(row) + " of the film";
    if (nearest < kNear)
        words += "; another key is " + written((float)nearest) + " rows away: the camera may swing";
    return words;
}

} // namespace odraz::maker

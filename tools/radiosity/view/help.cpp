#include "tools/radiosity/view/help.h"

#include "show/font.h"
#include "tools/common/text.h"
#include "tools/radiosity/export/render.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

// Sizes in heights of a digit
static constexpr float kLine = 2, kMargin = 1.5f, kSecond = 8, kWide = 33, kHigh = 2 * kMargin - 1;

std::vector<ViewKey> viewKeys(bool room) {
    std::vector<ViewKey> keys = {
        {"W A S D", "fly ahead, left, back, right"},
        {"Q E", "fly down, up"},
        {"Shift", "fly faster"},
        {"mouse", room ? "left button: look, right: turn the sky" : "left button: look around"},
        {"wheel", "exposure"}};
    if (room)
        keys.insert(keys.end(), {{"1 .. 9 0", "lamps; with Shift 11 to 16"},
                                 {"[ ]", "bands"},
                                 {"P", "exact rows, or clusters"},
                                 {"- =", "axes of the clusters"},
                                 {", .", "halve or double the clusters"},
                                 {"F2 .. F5", "patches, elements, wireframe, hemicube"}});
    else
        keys.insert(
            keys.end(),
            {{"1", "patches"}, {"2", "elements"}, {"3", "wireframe"}, {"4", "hemicube under the pointer"}});
    keys.insert(keys.end(), {{"B", "backs"},
                             {"T", "tone"},
                             {"C", "camera line"},
                             {"R", "back to the start"},
                             {"H F1", "this help"},
                             {"Esc", "quit"}});
    return keys;
}

std::string viewKeysText(std::span<const ViewKey> keys) {
    std::string all;
    for (const ViewKey &k : keys) all += common::format("%-10s %s\n", k.keys, k.does);
    return all;
}

pictures::Image viewHelp(std::span<const ViewKey> keys, int width, int height) {
    float lines = kLine * (float)keys.size();
    float size = std::min({11.f, (float)width / kWide, (float)height / (lines + kHigh)});
    pictures::Image p = {std::max((int)(kWide * size), 1), std::max((int)((lines + kHigh) * size), 1), {}};
    HeapFrame text(p.width, p.height);
    float y = (kMargin + 1) * size;
    for (const ViewKey &k : keys) {
        TextStyle style = {size, 0.12f, Align::Left, {1, 0.8f, 0.4f}, 1, 0};
        drawText(text.frame, k.keys, kMargin * size, y, style);
        style.radiance = {1, 1, 1};
        drawText(text.frame, k.does, (kMargin + kSecond) * size, y, style);
        y += kLine * size;
    }
    for (int j = 0; j < p.height; ++j)
        for (int i = 0; i < p.width; ++i)
            for (int k = 0; k < 3; ++k)
                p.rgb.push_back((uint8_t)std::lround(20 + 210 * std::clamp(text.at(k, i, j), 0.f, 1.f)));
    return p;
}

} // namespace odraz::radiosity

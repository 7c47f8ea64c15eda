#include "tools/radiosity/read/material_changes.h"

#include "tools/radiosity/read/mesh.h"

#include <algorithm>
#include <cstdio>

namespace odraz::radiosity {

namespace {

[[noreturn]] void refuse(const MaterialChange &c, const std::string &why) {
    throw common::Refused(c.option + " " + c.text + ": " + why);
}

// The names of the materials that may be changed, for a message.
std::string namesOf(const std::vector<MeshMaterial> &materials, const std::vector<bool> &used) {
    constexpr size_t kMost = 20;
    std::string names;
    size_t count = 0;
    for (size_t i = 0; i < materials.size(); ++i)
        if (used[i] && ++count <= kMost) names += (count > 1 ? ", " : "") + materials[i].name;
    return count > kMost ? names + " and " + std::to_string(count - kMost) + " more" : names;
}

void apply(MeshMaterial &m, const MaterialChange &c) {
    std::array<float, 3> &to = c.power ? m.emits : m.reflects;
    bool pictured = !c.power && !m.picture.path.empty();
    if (pictured && !c.factor) m.picture = {}, pictured = false;
    double most = c.power ? kMostPower : 1, largest = 0;
    for (size_t k = 0; k < 3; ++k) {
        auto change = [&](float &x) {
            double value = c.factor ? (double)x * c.value[k] : c.value[k];
            largest = std::max(largest, value);
            // Accept the maximum within rounding: a factor may give exactly that
            x = (float)(value > most && value < most * (1 + 1e-6) ? most : value);
        };
        if (pictured) change(m.picture.tint[k]);
        if (!pictured || c.factor) change(to[k]);
    }
    if (largest < most * (1 + 1e-6)) return;
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", largest);
    refuse(c, m.name + " would " + (c.power ? "emit " : "reflect ") + text + "; the most is " +
                  (c.power ? "1e12" : "1"));
}

} // namespace

MaterialChange readMaterialChange(const std::string &option, const std::string &text) {
    MaterialChange c = {option, text, option == "--power", "", false, {}};
    size_t at = text.rfind('=');
    std::string value = at == std::string::npos ? text : text.substr(at + 1);
    if (at != std::string::npos) c.name = text.substr(0, at);
    if (at == 0) refuse(c, "there is no name before the =");
    const auto count = 1 + std::count(value.begin(), value.end(), ',');
    if (count != 1 && count != 3) refuse(c, "the value must be R,G,B or one factor");
    auto numbers = common::numbersOf(option, value, (size_t)count);
    std::copy(numbers.begin(), numbers.end(), c.value.begin());
    c.factor = count == 1;
    if (c.factor) c.value[1] = c.value[2] = c.value[0];
    double most = c.power || c.factor ? kMostPower : 1;
    for (double x : c.value)
        if (!(x >= 0 && x <= most))
            refuse(c, c.factor  ? "a factor must be 0 to 1e12"
                      : c.power ? "power must be 0 to 1e12"
                                : "a reflectance must be 0 to 1");
    return c;
}

void addMaterialChanges(common::CommandLine &line, std::vector<MaterialChange> &to) {
    line.group(kMaterialGroup);
    auto add = [&](const std::string &option, const std::string &what) {
        line.option(
            option, "[NAME=]R,G,B|FACTOR",
            [&to, option](const std::string &text) { to.push_back(readMaterialChange(option, text)); },
            what + "; repeatable");
    };
    add("--reflectance", "the reflectance of the material NAME, 0 to 1; without NAME, of all materials");
    add("--power",
        "the radiance that the material NAME emits; without NAME, of all materials that emit. With "
        "this option no even sky is added");
}

void changeMaterials(std::vector<MeshMaterial> &materials, const std::vector<bool> &used,
                     const std::vector<MaterialChange> &changes) {
    for (const MaterialChange &c : changes) {
        bool named = false, changed = false;
        for (size_t i = 0; i < materials.size(); ++i) {
            MeshMaterial &m = materials[i];
            if (!used[i] || (!c.name.empty() && m.name != c.name)) continue;
            named = true;
            // A factor has no effect on a material that does not emit
            if (c.power && (c.factor || c.name.empty()) && !m.shines()) continue;
            apply(m, c);
            changed = true;
        }
        if (!named) refuse(c, "no polygon has this material; the materials are " + namesOf(materials, used));
        if (!changed)
            refuse(c, (c.name.empty() ? std::string("no material emits light") : c.name + " emits no light") +
                          ": name a material and give its R,G,B; the materials are " +
                          namesOf(materials, used));
    }
}

} // namespace odraz::radiosity

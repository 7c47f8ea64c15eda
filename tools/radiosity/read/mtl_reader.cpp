#include "tools/radiosity/read/mtl_reader.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh_builder.h"
#include "tools/radiosity/read/text_lines.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <strings.h>

namespace odraz::radiosity {

namespace {

using Colour = std::array<double, 3>;

constexpr const char *kMaterialWords[] = {"newmtl", "Kd", "Ke", "Ka", "map_Kd", "map_Ke", "Pm", "Pc", "Ps"};
// In their order
enum MaterialWord { kNew, kDiffuse, kEmission, kAmbient, kDiffuseMap, kEmissionMap, kMetal, kCoat, kSheen };

// Whether a keyword names a picture.
bool isMap(std::string_view word) {
    static const std::set<std::string_view> others = {"bump", "disp", "decal", "refl", "norm"};
    return others.count(word) || (!strncasecmp(word.data(), "map_", std::min<size_t>(word.size(), 4)) &&
                                  word.size() > 4 && word != "map_aat");
}

struct MtlReader {
    const std::string &model;
    std::vector<std::string> &notes;
    std::vector<MeshMaterial> materials = {};
    NotedKinds unused = {};                       // features, such as maps
    std::set<std::string> files = {}, names = {}; // libraries read; names of materials

    void note(const std::string &name, const std::string &what) {
        notes.push_back(model + ": material " + name + ": " + what);
    }
    void note(const std::string &what) { unused[what].push_back("material " + m.name); }

    // The current material.
    MeshMaterial m = {};
    MeshPicture other = {}; // a picture that is not used
    Colour kd = {}, ke = {}, ka = {};
    bool open = false, hasKd = false;
    std::string noKd = {}; // why it has no Kd

    [[noreturn]] void refuse(const std::string &what) const {
        throw ModelError(model + ": material " + m.name + ": " + what);
    }

    // Reads three numbers, one number for all three, or CIE XYZ, which becomes linear sRGB. Returns false if
    // the line has no colour, or gives a spectrum, which adds a note.
    bool readColour(const TextLines &line, Colour &c) {
        std::string_view rest = line.rest.substr(0, line.rest.find('#')), word = rest;
        const std::string_view kind = takeWord(word);
        const bool xyz = kind == "xyz";
        c = {};
        if (kind == "spectral") {
            std::string what = "its " + std::string(line.word) + " is a spectrum, which is not read";
            &c == &kd ? void(noKd = what) : note(m.name, what);
            return false;
        }
        if (rest.empty()) return false;
        if (xyz) rest = word;
        for (size_t k = 0; k < 3; ++k) {
            if (k && rest.empty())
                c[k] = c[0];
            else if (!takeNumber(rest, c[k]))
                refuse(std::string(line.word) + ": " + std::string(takeWord(rest)) + " is not a number");
        }
        if (!xyz) return true;
        c = pictures::rgbOfXyz(c);
        for (double &v : c) v = std::max(v, 0.); // negative values are outside the gamut
        return true;
    }

    void begin(const std::string &name) {
        finish();
        if (!names.insert(name).second) note(name, "it is defined twice; the first definition is used");
        m = {name, {}, {}};
        kd = ke = ka = {};
        hasKd = false, noKd = "it has no Kd";
        open = true;
    }
    void finish() {
        if (!open) return;
        open = false;
        // Old files have no Ke; an ambient colour above 1 marks a lamp
        if (*std::max_element(ka.begin(), ka.end()) > 1 && ke == Colour{}) {
            ke = ka;
            note(m.name, "its Ka is above 1 and is used as Ke");
        }
        bool pictured = !m.picture.path.empty(), glows = !m.emissionPicture.path.empty();
        if (!hasKd && (pictured || (ke == Colour{} && !glows))) {
            kd = {0.7, 0.7, 0.7};
            if (!pictured) note(m.name, noKd + ": it reflects 0.7");
        }
        setColours(m, kd, ke, {"Kd", "Ke"}, model, notes);
        // The colour multiplies the picture, unless it is 0: then the picture alone is meant
        if (pictured && hasKd && kd != Colour{}) m.picture.tint = m.reflects;
        if (glows && ke != Colour{}) m.emissionPicture.tint = m.emits;
        materials.push_back(m);
    }

    // Reads a picture: options with their values, and the name of the file, which may have blanks.
    void picture(const std::string &folder, const TextLines &line, MeshPicture &picture) {
        static const std::map<std::string, int> numbers = {{"-o", 3}, {"-s", 3}, {"-t", 3}, {"-mm", 2}};
        static const std::set<std::string> others = {"-blendu", "-blendv", "-boost",      "-bm",
                                                     "-cc",     "-clamp",  "-colorspace", "-imfchan",
                                                     "-texres", "-type"};
        MeshPicture to;
        std::string_view name = line.rest;
        for (std::string_view rest = name;; name = rest) {
            const std::string word(takeWord(rest));
            auto list = numbers.find(word);
            if (list == numbers.end() && !others.count(word)) break;
            if (&picture != &other && word != "-clamp" && word != "-s" && word != "-o")
                note(std::string(line.word) + "'s " + word + " is not used");
            if (list == numbers.end()) {
                std::string_view value = takeWord(rest);
                if (word == "-clamp") to.clamp = value == "on";
                continue;
            }
            double number;
            for (int k = 0; k < list->second && takeNumber(rest, number); ++k) {
                if (!(std::fabs(number) < 1e6))
                    refuse(std::string(line.word) + ": a scale or offset is not a number below 1e6");
                if (k < 2 && word == "-s") to.scale[(size_t)k] = (float)number;
                if (k < 2 && word == "-o") to.offset[(size_t)k] = (float)number;
            }
        }
        if (name.empty()) return;
        to.path = findFile(folder, std::string(name));
        common::noteInput(to.path);
        picture = to;
    }

    void read(const std::string &path) {
        if (!files.insert(path).second) return; // already read
        TextLines lines(path);
        const size_t before = materials.size();
        while (lines.next()) {
            const int keyword = lines.keyword(kMaterialWords);
            const std::string rest(lines.rest);
            if (keyword == kNew) {
                begin(rest);
                continue;
            }
            if (!open) continue;
            if (keyword == kDiffuse)
                hasKd = readColour(lines, kd);
            else if (keyword == kEmission || keyword == kAmbient)
                readColour(lines, keyword == kEmission ? ke : ka);
            else if (keyword == kDiffuseMap || keyword == kEmissionMap)
                picture(folderOf(path), lines, keyword == kDiffuseMap ? m.picture : m.emissionPicture);
            else if (double x; keyword >= 0 && takeNumber(lines.rest, x) && x > 0)
                note(keyword == kMetal ? "metal counts as diffuse"
                                       : "clearcoat and sheen (Pc, Ps) are not used");
            if (keyword >= 0) continue;
            if (isMap(lines.word) && !rest.empty())
                note(std::string(lines.word) + " is not used"), picture(folderOf(path), lines, other);
            // In some files a Tr of 1 means transparent, in others opaque
            const bool isD = lines.word == "d";
            if (isD && lines.rest.starts_with("-halo")) takeWord(lines.rest);
            if (double x; (isD || lines.word == "Tr") && takeNumber(lines.rest, x) && x < 1 && (isD || x > 0))
                note("opacity is not used, so all surfaces are opaque");
        }
        finish();
        for (const auto &[word, keyword] : lines.otherCase)
            notes.push_back(path + ": " + word + " is read as " + keyword);
        if (materials.size() == before)
            notes.push_back(path + (lines.isText ? ": has no material (newmtl)"
                                                 : ": is not a text file, and has no materials"));
    }
};

} // namespace

std::string folderOf(const std::string &path) { return path.substr(0, path.rfind('/') + 1); }

// The path of an entry of a folder, by its name, or by one in another case or Unicode form; empty: none.
static std::string findEntry(const std::string &folder, const std::string &name) {
    std::error_code wrong;
    if (std::filesystem::exists(folder + name, wrong)) return folder + name;
    const std::string wanted = common::decomposed(name);
    for (const auto &entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, wrong)) {
        const std::string found = entry.path().filename().string();
        if (!strcasecmp(common::decomposed(found).c_str(), wanted.c_str())) return folder + found;
    }
    return "";
}

std::string findFile(const std::string &folder, std::string name) {
    namespace fs = std::filesystem;
    std::error_code wrong;
    if (name.size() > 1 && name[0] == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    if (fs::exists(folder + name, wrong)) return folder + name;
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name[0] == '/' && fs::exists(name, wrong)) return name;
    // Try the name as given, then only its last part, in the same folder
    for (std::string tried : {name, name.substr(name.rfind('/') + 1)}) {
        if (tried.empty() || tried[0] == '/') continue;
        std::string path = folder;
        for (const fs::path &part : fs::path(tried)) {
            if (!path.empty() && path.back() != '/') path += '/';
            path = findEntry(path, part.string());
            if (path.empty()) break;
        }
        if (!path.empty()) return path;
    }
    return folder + name;
}

std::vector<MeshMaterial> readMaterials(const std::string &model, const std::vector<std::string> &libraries,
                                        std::vector<std::string> &notes) {
    MtlReader reader = {model, notes};
    std::string folder = folderOf(model);
    for (const std::string &words : libraries) {
        // The text is one name with blanks, or several names
        std::vector<std::string> names = {words};
        std::error_code ignored;
        if (words.find_first_of(" \t") != std::string::npos &&
            !std::filesystem::exists(findFile(folder, words), ignored)) {
            std::istringstream in(words);
            names.clear();
            for (std::string name; in >> name;) names.push_back(name);
        }
        for (const std::string &name : names) try {
                reader.read(findFile(folder, name));
            } catch (const ModelError &) {
                throw;
            } catch (const common::Refused &e) {
                notes.push_back(model + ": its materials cannot be read: " + e.what());
            }
    }
    noteKinds(model, reader.unused, notes);
    return reader.materials;
}

} // namespace odraz::radiosity

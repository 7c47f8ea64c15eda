#include "tools/radiosity/read/mtl_reader.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/read/obj_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace odraz::radiosity {

namespace {

using Colour = std::array<double, 3>;

std::string folderOf(const std::string &path) { return path.substr(0, path.rfind('/') + 1); }

// Reads three numbers, one number for all three, or CIE XYZ (linear, in sRGB's primaries). False for spectra.
bool readColour(const std::string &words, Colour &c) {
    bool xyz = !words.compare(0, 4, "xyz ");
    const char *p = words.c_str() + (xyz ? 4 : 0);
    for (size_t k = 0; k < 3; ++k) {
        char *end;
        c[k] = std::strtod(p, &end);
        if (end == p && k == 0) return false;
        if (end == p) c[k] = c[0];
        p = end;
    }
    if (!xyz) return true;
    auto [x, y, z] = c;
    c = {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
         0.0557 * x - 0.2040 * y + 1.0570 * z};
    for (double &v : c) v = std::max(v, 0.); // negative values are outside the gamut
    return true;
}

struct Reader {
    const std::string &model;
    std::vector<std::string> &notes;
    std::vector<MeshMaterial> materials;

    void note(const std::string &name, const std::string &what) {
        notes.push_back(model + ": material " + name + ": " + what);
    }

    // The material that is being read.
    MeshMaterial m;
    Colour kd, ke, ka;
    bool open = false, hasKd, spectral;

    void begin(const std::string &name) {
        finish();
        m = {name, {}, {}, {}};
        kd = ke = ka = {};
        hasKd = spectral = false;
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
        bool pictured = !m.picture.path.empty();
        // A picture is multiplied by Kd, unless Kd is 0: then the picture alone is meant
        if (pictured)
            for (size_t k = 0; k < 3; ++k)
                m.picture.tint[k] = hasKd && kd != Colour{} ? (float)std::min(kd[k], 1.) : 1;
        if (!hasKd && (pictured || ke == Colour{})) {
            kd = {0.7, 0.7, 0.7};
            if (!pictured)
                note(m.name, spectral ? "its Kd is a spectrum, which is not read: it reflects 0.7"
                                      : "it has no Kd: it reflects 0.7");
        }
        bool above = false;
        for (size_t k = 0; k < 3; ++k) {
            if (!(kd[k] >= 0 && kd[k] < 1e12) || !(ke[k] >= 0 && ke[k] < 1e12))
                throw ModelError(model + ": material " + m.name +
                                 ": Kd must lie between 0 and 1, Ke must not be negative");
            above |= kd[k] > 1;
            m.reflects[k] = (float)std::min(kd[k], 1.), m.emits[k] = (float)ke[k];
        }
        if (above) note(m.name, "its Kd must lie between 0 and 1: more counts as 1");
        materials.push_back(m);
    }

    // Reads options with their values, and the file's name, which may have blanks.
    void picture(const std::string &folder, const std::string &words) {
        static const std::map<std::string, int> numbers = {{"-o", 3}, {"-s", 3}, {"-t", 3}, {"-mm", 2}};
        static const std::set<std::string> others = {"-blendu", "-blendv",  "-boost",  "-bm",  "-cc",
                                                     "-clamp",  "-imfchan", "-texres", "-type"};
        MeshPicture to;
        std::istringstream in(words);
        std::string word, value;
        std::streampos at = in.tellg();
        for (; in >> word; at = in.tellg()) {
            auto list = numbers.find(word);
            if (list == numbers.end() && !others.count(word)) break;
            if (list == numbers.end()) {
                in >> value;
                if (word == "-clamp") to.clamp = value == "on";
                continue;
            }
            for (int k = 0; k < list->second; ++k) {
                std::streampos before = in.tellg();
                char *end = nullptr;
                float number = in >> value ? std::strtof(value.c_str(), &end) : 0;
                if (!end || *end) { // not a number: it is the next word
                    in.clear();
                    in.seekg(before);
                    break;
                }
                if (!(std::fabs(number) < 1e6f))
                    throw ModelError(model + ": material " + m.name +
                                     ": map_Kd: a scale or offset is not a number below 1e6");
                if (k < 2 && word == "-s") to.scale[(size_t)k] = number;
                if (k < 2 && word == "-o") to.offset[(size_t)k] = number;
            }
        }
        if (at < 0 || !in) return; // no name
        std::string name = words.substr((size_t)at);
        to.path = findFile(folder, name.substr(name.find_first_not_of(" \t")));
        m.picture = to;
    }

    void read(const std::string &path) {
        std::istringstream in(plainText(common::readWhole(path)));
        std::string line, rest;
        while (std::getline(in, line)) {
            if (isLine(line, "newmtl", rest))
                begin(rest);
            else if (!open)
                continue;
            else if (isLine(line, "Kd", rest)) {
                hasKd = readColour(rest, kd);
                spectral = !hasKd;
            } else if (isLine(line, "Ke", rest)) {
                if (!readColour(rest, ke)) ke = {};
            } else if (isLine(line, "Ka", rest)) {
                if (!readColour(rest, ka)) ka = {};
            } else if (isLine(line, "map_Kd", rest) || isLine(line, "map_kd", rest))
                picture(folderOf(path), rest);
        }
        finish();
    }
};

} // namespace

std::string findFile(const std::string &folder, std::string name) {
    namespace fs = std::filesystem;
    std::error_code wrong;
    if (name.size() > 1 && name[0] == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    if (fs::exists(folder + name, wrong)) return folder + name;
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name[0] == '/' && fs::exists(name, wrong)) return name;
    // Try the name as given, then only its last part, in the same folder
    for (std::string tried : {name, name.substr(name.rfind('/') + 1)}) {
        std::string path = folder + tried;
        if (tried.empty() || tried[0] == '/') continue;
        if (fs::exists(path, wrong)) return path;
        std::string last = path.substr(path.rfind('/') + 1), beside = folderOf(path);
        for (const auto &entry : fs::directory_iterator(beside.empty() ? "." : beside, wrong)) {
            std::string found = entry.path().filename().string();
            if (!strcasecmp(found.c_str(), last.c_str())) return beside + found;
        }
    }
    return folder + name;
}

std::vector<MeshMaterial> readMaterials(const std::string &model, const std::vector<std::string> &libraries,
                                        std::vector<std::string> &notes) {
    Reader reader = {model, notes, {}, {}, {}, {}, {}, false, false, false};
    std::string folder = folderOf(model), wrong;
    for (const std::string &words : libraries) {
        // One name with blanks, or several
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
                wrong = e.what();
            }
    }
    if (!wrong.empty()) notes.push_back(model + ": its materials cannot be read: " + wrong);
    return reader.materials;
}

} // namespace odraz::radiosity

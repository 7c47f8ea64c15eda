#include "maker/tracks.h"

#include "maker/panel/content.h"
#include "timeline/key_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace odraz::maker {

namespace {

constexpr const char *kChannelNames[kChannels] = {"eye.x",    "eye.y",    "eye.z", "target.x",
                                                  "target.y", "target.z", "roll",  "lens"};

// Returns "scenes/hall.keys" for "./intro/show/scenes/hall.keys".
std::string fileOf(const KeyTable &table) {
    const std::string file = table.file, show = "/show/";
    return file.substr(file.rfind(show) + show.size());
}

// Returns "toTheDoor" for "kToTheDoor".
std::string plainName(std::string name) {
    if (name.size() > 1 && name[0] == 'k' && std::isupper((unsigned char)name[1])) {
        name.erase(0, 1);
        name[0] = (char)std::tolower((unsigned char)name[0]);
    }
    return name;
}

Interpolation fromRocket(rocket::Interpolation i) {
    constexpr Interpolation kInterpolations[] = {kStep, Interpolation::Linear, Interpolation::Smooth, kRamp};
    return kInterpolations[(int)i];
}
rocket::Interpolation toRocket(Interpolation i) {
    using enum rocket::Interpolation;
    return i == kStep ? Step : i == kRamp ? Ramp : i == Interpolation::Smooth ? Smooth : Linear;
}

// Joins a camera's channels. In an editor each may have keys on different rows; the film's table has all
// numbers on every row. A channel without a key on a row gets the value of its curve there.
std::vector<KeyNumbers> merged(const std::vector<std::vector<Key>> &channels) {
    std::set<float> rows;
    std::vector<CameraKey> paths[kChannels]; // path c has only channel c
    for (size_t c = 0; c < kChannels; ++c)
        for (const Key &k : channels[c]) {
            rows.insert(k.row);
            CameraKey &key = paths[c].emplace_back(CameraKey{k.row, {}, {}, 0, 0});
            (&key.eye.x)[c] = k.value;
        }
    std::vector<KeyNumbers> result;
    for (float row : rows) {
        KeyNumbers &key = result.emplace_back(KeyNumbers{row});
        for (size_t c = 0; c < kChannels; ++c) {
            CameraKey at = pose({paths[c].data(), (int)paths[c].size()}, row);
            key.push_back((&at.eye.x)[c]);
        }
    }
    return result;
}

} // namespace

void Tracks::readFilm(const Live &from) {
    live = &from;
    Content film = contentOf(live->inspector());
    shots = film.shots;
    Events rows;
    for (const EventInfo &e : film.events) rows[e.name] = e.row;
    std::set<std::string> names;
    for (KeyTable *t = live->keyTables(); t; t = t->next) names.insert(fileOf(*t));
    files.read(names, rows);
    tables.clear();
    for (KeyTable *t = live->keyTables(); t; t = t->next) {
        // Find the shot of a path, or the first shot of the scene that the file is named after
        std::string file = fileOf(*t), scene = std::filesystem::path(file).stem();
        auto shot = std::find_if(shots.begin(), shots.end(), [&](const ShotInfo &s) {
            return t->camera ? s.path->keys == t->poses : live->sceneName(s.scene) == scene;
        });
        int i = files.find(file, t->name);
        if (shot == shots.end() || i < 0) continue;
        std::string name = live->sceneName(shot->scene) + (t->camera ? std::string(".camera.") : ":");
        double shift = shot->story * kRowsPerSecond + (double)t->start;
        tables.push_back({t, shot->scene, shift, i, name + plainName(t->name), 0});
    }
    std::reverse(tables.begin(), tables.end()); // the list of tables begins with the newest one
    std::stable_sort(tables.begin(), tables.end(), [](const FilmTable &a, const FilmTable &b) {
        return std::pair(a.scene, !a.live->camera) < std::pair(b.scene, !b.live->camera);
    });
    allNames.clear();
    tableOf.clear();
    for (size_t i = 0; i < tables.size(); ++i) {
        FilmTable &t = tables[i];
        t.firstTrack = allNames.size();
        if (!t.live->camera) allNames.push_back(t.name);
        for (size_t c = 0; t.live->camera && c < kChannels; ++c)
            allNames.push_back(t.name + ":" + kChannelNames[c]);
        tableOf.resize(allNames.size(), i);
    }
    show();
}

const std::vector<KeyNumbers> &Tracks::ownKeys(const FilmTable &t) const {
    return files.tables()[(size_t)t.file].keys;
}

std::vector<Key> Tracks::editedChannel(const FilmTable &t, size_t channel) const {
    std::vector<Key> keys;
    for (const KeyNumbers &k : ownKeys(t))
        keys.push_back(t.live->camera ? Key{k[0], k[channel + 1], Interpolation::Smooth} : keyOf(k));
    std::vector<Key> result = keys;
    auto edit = edits.find(allNames[t.firstTrack + channel]);
    if (edit == edits.end()) return result;
    const auto &[editor, byHand] = edit->second;
    std::erase_if(result, [&](const Key &k) {
        double row = t.filmRow(k.row);
        return row >= 0 && !byHand.count((uint32_t)row);
    });
    for (auto &[row, key] : editor) {
        if (byHand.count(row)) continue;
        // Keep the exact row of the film's key, if there is one
        auto here = std::find_if(keys.begin(), keys.end(),
                                 [&](const Key &k) { return t.filmRow(k.row) == (double)row; });
        float at = here == keys.end() ? (float)((double)row - t.shift) : here->row;
        result.push_back({at, key.value, fromRocket(key.interpolation)});
    }
    std::stable_sort(result.begin(), result.end(), [](const Key &a, const Key &b) { return a.row < b.row; });
    return result;
}

rocket::Track Tracks::track(size_t i) const {
    rocket::Track result;
    const FilmTable &t = tables[tableOf[i]];
    for (const Key &k : editedChannel(t, i - t.firstTrack))
        if (double row = t.filmRow(k.row); row >= 0)
            result[(uint32_t)row] = {k.value, toRocket(k.interpolation)};
    return result;
}

int Tracks::offRows() const {
    int count = 0;
    for (const FilmTable &t : tables) {
        int off = 0;
        double last = -1; // the second of two keys on a row (a jump) has no row in Rocket
        for (const KeyNumbers &k : ownKeys(t)) {
            double row = (double)k[0] + t.shift;
            off += row < 0 || row != std::round(row) || row == last;
            last = row;
        }
        count += off * (t.live->camera ? (int)kChannels : 1);
    }
    return count;
}

void Tracks::takeFromEditor(size_t i, const rocket::Track &now) {
    Edit &edit = edits[allNames[i]];
    auto changed = [&](uint32_t row) {
        auto a = edit.editor.find(row);
        auto b = now.find(row);
        return (a == edit.editor.end()) != (b == now.end()) || (b != now.end() && a->second != b->second);
    };
    std::erase_if(edit.byHand, changed);
    edit.editor = now;
    if (now.empty()) edits.erase(allNames[i]);
}

std::vector<KeyNumbers> Tracks::editedKeys(const FilmTable &t) const {
    size_t count = t.live->camera ? kChannels : 1;
    bool edited = false;
    for (size_t c = 0; c < count; ++c) edited |= edits.count(allNames[t.firstTrack + c]) > 0;
    if (!edited) return ownKeys(t);
    std::vector<std::vector<Key>> channels;
    for (size_t c = 0; c < count; ++c) channels.push_back(editedChannel(t, c));
    std::vector<KeyNumbers> result;
    if (t.live->camera)
        result = merged(channels);
    else
        for (const Key &k : channels[0]) result.push_back(numbersOf(k));
    for (KeyNumbers &key : result) key = files.tables()[(size_t)t.file].saved.rounded(key);
    return result;
}

void Tracks::show() {
    unsavedByEditor = 0;
    for (const FilmTable &t : tables) {
        std::vector<KeyNumbers> now = editedKeys(t);
        unsavedByEditor += now != ownKeys(t);
        now.resize(std::min(now.size(), (size_t)kMostKeys));
        std::vector<Key> keys;
        std::vector<CameraKey> poses;
        for (const KeyNumbers &k : now)
            if (t.live->camera)
                poses.push_back(cameraKeyOf(k));
            else
                keys.push_back(keyOf(k));
        const void *all = t.live->camera ? (const void *)poses.data() : keys.data();
        live->setKeys(*t.live, all, (int)now.size());
    }
}

std::string Tracks::save(std::string &message) {
    std::string wrong;
    for (const FilmTable &t : tables) {
        std::vector<KeyNumbers> now = editedKeys(t);
        if (now == ownKeys(t)) continue; // no edits from the editor, or the same keys
        bool foreign = !t.live->camera && std::any_of(now.begin(), now.end(), [](const KeyNumbers &k) {
            return keyOf(k).interpolation >= kStep;
        });
        if (foreign)
            wrong += (wrong.empty() ? "not saved: " : "; ") + t.name +
                     ": the film has no steps and ramps: choose linear or smooth";
        else
            files.change(t.file, std::move(now));
    }
    std::set<std::string> written;
    std::string unwritten = files.save(written);
    if (!wrong.empty() && !unwritten.empty()) wrong += "; ";
    message = written.empty() ? "nothing to save" : "saved";
    for (const std::string &file : written) message += (file == *written.begin() ? " " : ", ") + file;
    show();
    return wrong + unwritten;
}

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

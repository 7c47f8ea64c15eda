#include "maker/tracks.h"

#include "maker/panel/content.h"
#include "timeline/key_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace odraz::maker {

namespace {

constexpr const char *kChannelNames[kChannels] = {"eye.x",    "eye.y",    "eye.z", "target.x",
                                                  "target.y", "target.z", "roll",  "lens"};

// "./intro/show/scenes/hall.keys" as "scenes/hall.keys"
std::string fileOf(const KeyTable &table) {
    const std::string file = table.file, show = "/show/";
    return file.substr(file.rfind(show) + show.size());
}

// "kToTheDoor" as "toTheDoor"
std::string plainName(std::string name) {
    if (name.size() > 1 && name[0] == 'k' && std::isupper((unsigned char)name[1])) {
        name.erase(0, 1);
        name[0] = (char)std::tolower((unsigned char)name[0]);
    }
    return name;
}

Interpolation fromRocket(rocket::Interpolation i) {
    constexpr Interpolation kOurs[] = {kStep, Interpolation::Linear, Interpolation::Smooth, kRamp};
    return kOurs[(int)i];
}
rocket::Interpolation toRocket(Interpolation i) {
    using enum rocket::Interpolation;
    return i == kStep ? Step : i == kRamp ? Ramp : i == Interpolation::Smooth ? Smooth : Linear;
}

// In an editor, each number of a camera may have keys on rows of its own. The film's table has all numbers on
// every row: a number without a key there gets the value of its own curve.
std::vector<KeyNumbers> merged(const std::vector<std::vector<Key>> &channels) {
    std::set<float> rows;
    std::vector<CameraKey> paths[kChannels]; // of each only one number is used
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

void Tracks::find(const Live &from) {
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
        // A path's own shot, or the first shot of the scene that the file is named after
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
    std::reverse(tables.begin(), tables.end()); // the list begins with the last
    std::stable_sort(tables.begin(), tables.end(), [](const Table &a, const Table &b) {
        return std::pair(a.scene, !a.live->camera) < std::pair(b.scene, !b.live->camera);
    });
    allNames.clear();
    tableOf.clear();
    for (size_t i = 0; i < tables.size(); ++i) {
        Table &t = tables[i];
        t.firstTrack = allNames.size();
        if (!t.live->camera) allNames.push_back(t.name);
        for (size_t c = 0; t.live->camera && c < kChannels; ++c)
            allNames.push_back(t.name + ":" + kChannelNames[c]);
        tableOf.resize(allNames.size(), i);
    }
    show();
}

const std::vector<KeyNumbers> &Tracks::own(const Table &t) const {
    return files.tables()[(size_t)t.file].keys;
}

std::vector<Key> Tracks::edited(const Table &t, size_t channel) const {
    std::vector<Key> mine;
    for (const KeyNumbers &k : own(t))
        mine.push_back(t.live->camera ? Key{k[0], k[channel + 1], Interpolation::Smooth} : keyOf(k));
    std::vector<Key> result = mine;
    auto edit = edits.find(allNames[t.firstTrack + channel]);
    if (edit == edits.end()) return result;
    const auto &[editor, byHand] = edit->second;
    std::erase_if(result, [&](const Key &k) {
        double row = t.filmRow(k.row);
        return row >= 0 && !byHand.count((uint32_t)row);
    });
    for (auto &[row, key] : editor) {
        if (byHand.count(row)) continue;
        // The exact row of the film's own key, if there is one
        auto there = std::find_if(mine.begin(), mine.end(),
                                  [&](const Key &k) { return t.filmRow(k.row) == (double)row; });
        float at = there == mine.end() ? (float)((double)row - t.shift) : there->row;
        result.push_back({at, key.value, fromRocket(key.interpolation)});
    }
    std::stable_sort(result.begin(), result.end(), [](const Key &a, const Key &b) { return a.row < b.row; });
    return result;
}

rocket::Track Tracks::track(size_t i) const {
    rocket::Track result;
    const Table &t = tables[tableOf[i]];
    for (const Key &k : edited(t, i - t.firstTrack))
        if (double row = t.filmRow(k.row); row >= 0)
            result[(uint32_t)row] = {k.value, toRocket(k.interpolation)};
    return result;
}

int Tracks::offRows() const {
    int count = 0;
    for (const Table &t : tables) {
        int off = 0;
        double last = -1; // two keys on a row are a jump, which Rocket does not have either
        for (const KeyNumbers &k : own(t)) {
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

std::vector<KeyNumbers> Tracks::contents(const Table &t) const {
    size_t count = t.live->camera ? kChannels : 1;
    bool untouched = true; // by an editor
    for (size_t c = 0; c < count; ++c) untouched &= !edits.count(allNames[t.firstTrack + c]);
    if (untouched) return own(t);
    std::vector<std::vector<Key>> channels;
    for (size_t c = 0; c < count; ++c) channels.push_back(edited(t, c));
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
    for (const Table &t : tables) {
        std::vector<KeyNumbers> now = contents(t);
        unsavedByEditor += now != own(t);
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
    for (const Table &t : tables) {
        std::vector<KeyNumbers> now = contents(t);
        if (now == own(t)) continue; // edited by hand alone, or an editor has what the film has
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

} // namespace odraz::maker

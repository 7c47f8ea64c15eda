#include "maker/tracks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace odraz {

namespace {

constexpr const char *kChannelNames[kChannels] = {"eye.x",    "eye.y",    "eye.z", "target.x",
                                                  "target.y", "target.z", "roll",  "lens"};
constexpr int kMostTables = 512;

// "kToTheDoor" as "toTheDoor", "kGrow[1]" as "grow1"
std::string tableName(const Table &t, const std::vector<Symbol> &symbols) {
    auto *at = (const char *)t.keys;
    for (const Symbol &s : symbols) {
        if (at < s.at || at >= s.at + s.size) continue;
        std::string name = s.name;
        if (name.size() > 1 && name[0] == 'k' && std::isupper((unsigned char)name[1])) {
            name.erase(0, 1);
            name[0] = (char)std::tolower((unsigned char)name[0]);
        }
        size_t one = (size_t)t.count * (t.camera ? sizeof(CameraKey) : sizeof(Key));
        if (one < s.size) name += std::to_string((size_t)(at - s.at) / one);
        return name;
    }
    return "track";
}

Interpolation fromRocket(rocket::Interpolation i) {
    constexpr Interpolation kOurs[] = {kStep, Interpolation::Linear, Interpolation::Smooth, kRamp};
    return kOurs[(int)i];
}
rocket::Interpolation toRocket(Interpolation i) {
    using enum rocket::Interpolation;
    return i == kStep ? Step : i == kRamp ? Ramp : i == Interpolation::Smooth ? Smooth : Linear;
}

} // namespace

void Tracks::find(const Live &from, Intro &intro, const std::vector<Symbol> &symbols) {
    live = &from;
    live->replaceTables(nullptr, 0);
    tables.resize(kMostTables);
    tables.resize((size_t)live->findTables(intro, tables.data(), kMostTables));
    all.clear();
    allNames.clear();
    for (size_t t = 0; t < tables.size(); ++t) {
        const Table &table = tables[t];
        std::string scene = live->sceneName(table.scene), name = tableName(table, symbols);
        std::string prefix = table.camera ? scene + ".camera." + name : scene + ":" + name;
        auto taken = [&](const std::string &p) {
            return std::any_of(allNames.begin(), allNames.end(),
                               [&](auto &n) { return n == p || n == p + ":" + kChannelNames[0]; });
        };
        std::string unique = prefix;
        for (int i = 2; taken(unique); ++i) unique = prefix + "-" + std::to_string(i);
        for (int c = 0; c < (table.camera ? kChannels : 1); ++c) {
            all.push_back({t, c});
            allNames.push_back(table.camera ? unique + ":" + kChannelNames[c] : unique);
        }
    }
    show();
}

std::vector<Key> Tracks::own(const One &one) const {
    const Table &t = tables[one.table];
    if (!t.camera) return {(const Key *)t.keys, (const Key *)t.keys + t.count};
    std::vector<Key> result;
    for (int i = 0; i < t.count; ++i) {
        const CameraKey &k = ((const CameraKey *)t.keys)[i];
        result.push_back({k.row, (&k.eye.x)[one.channel], Interpolation::Smooth});
    }
    return result;
}

bool Tracks::onRow(const Table &t, const Key &key, uint32_t row) const {
    return std::round(filmRow(t, key.row)) == (double)row;
}

std::vector<Key> Tracks::edited(size_t i) const {
    const Table &t = tables[all[i].table];
    std::vector<Key> mine = own(all[i]), result = mine;
    auto edit = edits.find(allNames[i]);
    if (edit == edits.end()) return result;
    // The exact row of the film's own key, if there is one
    auto exact = [&](uint32_t row) {
        for (const Key &k : mine)
            if (onRow(t, k, row)) return k.row;
        return (float)((double)row - (double)t.shift);
    };
    auto drop = [&](uint32_t row) { std::erase_if(result, [&](const Key &k) { return onRow(t, k, row); }); };
    const Edit &e = edit->second;
    if (!e.editor.empty()) std::erase_if(result, [&](const Key &k) { return filmRow(t, k.row) > -0.5; });
    for (auto &[row, key] : e.editor)
        result.push_back({exact(row), key.value, fromRocket(key.interpolation)});
    for (auto &[row, value] : e.hand) {
        float at = exact(row);
        Interpolation kind = Interpolation::Smooth;
        for (const Key &k : result)
            if (onRow(t, k, row)) kind = k.interpolation;
        drop(row);
        if (value) result.push_back({at, *value, kind});
    }
    std::stable_sort(result.begin(), result.end(), [](const Key &a, const Key &b) { return a.row < b.row; });
    return result;
}

rocket::Track Tracks::track(size_t i) const {
    rocket::Track result;
    const Table &t = tables[all[i].table];
    for (const Key &k : edited(i)) {
        double row = std::round(filmRow(t, k.row));
        if (row >= 0) result[(uint32_t)row] = {k.value, toRocket(k.interpolation)};
    }
    return result;
}

int Tracks::offRows() const {
    int count = 0;
    for (const One &one : all) {
        double last = -1; // two keys on a row are a jump, which Rocket has not, either
        for (const Key &k : own(one)) {
            double row = filmRow(tables[one.table], k.row);
            count += row < 0 || row != std::round(row) || row == last;
            last = row;
        }
    }
    return count;
}

void Tracks::takeFromEditor(size_t i, const rocket::Track &now) {
    Edit &edit = edits[allNames[i]];
    auto changed = [&](uint32_t row) {
        auto a = std::as_const(edit.editor).find(row), b = now.find(row);
        return (a == edit.editor.cend()) != (b == now.end()) || (b != now.end() && a->second != b->second);
    };
    std::erase_if(edit.hand, [&](auto &key) { return changed(key.first); });
    edit.editor = now;
    if (edit.none()) edits.erase(allNames[i]);
}

void Tracks::set(size_t i, uint32_t row, std::optional<float> value) { edits[allNames[i]].hand[row] = value; }

int Tracks::cameraAt(double row) const {
    const void *path = live->pathAt(row / kRowsPerSecond);
    for (size_t i = 0; i < all.size(); ++i)
        if (tables[all[i].table].keys == path) return (int)i;
    return -1;
}

void Tracks::show() {
    live->replaceTables(nullptr, 0);
    replaced.clear();
    keys.clear();
    poses.clear();
    for (size_t i = 0; i < all.size(); ++i) {
        if (!edits.count(allNames[i])) continue;
        const Table &t = tables[all[i].table];
        auto r = std::find_if(replaced.begin(), replaced.end(), [&](auto &r) { return r.keys == t.keys; });
        if (r == replaced.end()) r = replaced.insert(r, {t.keys, {}, {}});
        const std::vector<Key> &now = keys.emplace_back(edited(i));
        if (!t.camera) {
            r->track = {now.data(), (int)now.size()};
            continue;
        }
        std::vector<CameraKey> &path = poses.emplace_back();
        for (const Key &k : now) {
            CameraKey pose = {k.row, {}, {}, 0, 0};
            (&pose.eye.x)[all[i].channel] = k.value;
            path.push_back(pose);
        }
        r->channels[all[i].channel] = {path.data(), (int)path.size()};
    }
    live->replaceTables(replaced.data(), (int)replaced.size());
}

} // namespace odraz

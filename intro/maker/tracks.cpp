#include "maker/tracks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <utility>

namespace odraz {

using maker::KeyNumbers;

namespace {

constexpr const char *kChannelNames[kChannels] = {"eye.x",    "eye.y",    "eye.z", "target.x",
                                                  "target.y", "target.z", "roll",  "lens"};
constexpr int kMostTables = 512;
constexpr int kView = 6; // eye and target: the first numbers of a camera

// "kToTheDoor" as "toTheDoor", "kGrow[1]" as "grow1"
std::string tableName(const Table &t, const std::vector<Symbol> &symbols) {
    int element;
    const Symbol *s = symbolOf(symbols, t, element);
    if (!s) return "track";
    std::string name = s->name;
    if (name.size() > 1 && name[0] == 'k' && std::isupper((unsigned char)name[1])) {
        name.erase(0, 1);
        name[0] = (char)std::tolower((unsigned char)name[0]);
    }
    return element < 0 ? name : name + std::to_string(element);
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
    hand.find(tables, symbols);
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

size_t Tracks::firstOf(size_t table) const {
    size_t first = 0;
    while (all[first].table != table) ++first;
    return first;
}

std::vector<Key> Tracks::own(const One &one) const {
    const Table &t = tables[one.table];
    std::vector<Key> result;
    for (const KeyNumbers &k : hand.keys(t))
        result.push_back(t.camera ? Key{k[0], k[(size_t)one.channel + 1], Interpolation::Smooth}
                                  : maker::keyOf(k));
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
    const Edit &e = edit->second;
    if (!e.editor.empty())
        std::erase_if(result, [&](const Key &k) {
            double row = std::round(filmRow(t, k.row));
            return row > -0.5 && !e.byHand.count((uint32_t)row);
        });
    for (auto &[row, key] : e.editor)
        if (!e.byHand.count(row)) result.push_back({exact(row), key.value, fromRocket(key.interpolation)});
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
    std::erase_if(edit.byHand, changed);
    edit.editor = now;
    if (edit.none()) edits.erase(allNames[i]);
}

int Tracks::cameraAt(double row) const {
    const void *path = live->pathAt(row / kRowsPerSecond);
    for (size_t i = 0; i < all.size(); ++i)
        if (tables[all[i].table].keys == path) return (int)i;
    return -1;
}

uint32_t Tracks::rowOfView(double row) const {
    double nearest = std::fmax(std::round(row), 0);
    if (live->pathAt(nearest / kRowsPerSecond) != live->pathAt(row / kRowsPerSecond))
        nearest = std::fmax(std::floor(row), 0);
    return (uint32_t)nearest;
}

std::string Tracks::setByHand(uint32_t row, const CameraKey *camera) {
    int first = cameraAt(row);
    if (first < 0) return "there is no camera's path";
    const Table &t = tables[all[(size_t)first].table];
    if (std::string why = hand.whyNot(t); !why.empty()) return names()[(size_t)first] + ": " + why;
    std::vector<KeyNumbers> now = hand.keys(t);
    auto here = std::find_if(now.begin(), now.end(), [&](auto &k) { return onRow(t, maker::keyOf(k), row); });
    if (!camera) {
        if (here == now.end()) return "there is no key";
        if (now.size() == 1) return "it is the path's only key";
        now.erase(here);
    } else {
        if (here == now.end()) {
            std::vector<CameraKey> path;
            for (const KeyNumbers &k : now) path.push_back(maker::cameraKeyOf(k));
            double own = (double)row - (double)t.shift;
            here = now.insert(here, maker::numbersOf(pose({path.data(), (int)path.size()}, own)));
        }
        KeyNumbers view = maker::numbersOf(*camera);
        std::copy_n(view.begin() + 1, kView, here->begin() + 1);
        // To the millimetre, and to a thousandth of a degree: more cannot be seen, and fewer digits read well
        for (size_t n = 1; n < here->size(); ++n) (*here)[n] = std::round((*here)[n] * 1000) / 1000;
    }
    for (int c = 0; c < kChannels; ++c) {
        auto edit = edits.find(allNames[(size_t)(first + c)]);
        if (edit != edits.end()) edit->second.byHand.insert(row);
    }
    hand.change(t, std::move(now));
    show();
    return "";
}
std::string Tracks::setView(uint32_t row, const CameraKey &camera) { return setByHand(row, &camera); }
std::string Tracks::removeView(uint32_t row) { return setByHand(row, nullptr); }

std::string Tracks::rowInWords(uint32_t row) const {
    constexpr double kNear = 4; // rows, a beat
    int first = cameraAt(row);
    if (first < 0) return "row " + std::to_string(row);
    const Table &t = tables[all[(size_t)first].table];
    double own = (double)row - (double)t.shift, nearest = kNear;
    for (const KeyNumbers &k : contents(all[(size_t)first].table))
        if (double away = std::fabs((double)k[0] - own); away > 0.5) nearest = std::min(nearest, away);
    char words[160];
    int length = std::snprintf(words, sizeof words, "row %g of %s", own, live->sceneName(t.scene));
    if (t.shift != 0)
        length += std::snprintf(words + length, sizeof words - (size_t)length, ", %u of the film", row);
    if (nearest < kNear)
        std::snprintf(words + length, sizeof words - (size_t)length,
                      ". another key is %g rows away: the camera may swing", nearest);
    return words;
}

bool Tracks::edited(const Table &t, size_t table) const {
    if (hand.edited(t)) return true;
    for (size_t i = 0; i < all.size(); ++i)
        if (all[i].table == table && edits.count(allNames[i])) return true;
    return false;
}

// An editor may give one number of a camera keys on other rows than another. The film's table has all numbers
// on every row, so what is shown has, too: a number without a key there is where its own curve is.
std::vector<KeyNumbers> Tracks::contents(size_t table) const {
    const Table &t = tables[table];
    std::vector<KeyNumbers> result;
    size_t first = firstOf(table);
    if (!t.camera) {
        for (const Key &k : edited(first)) result.push_back(maker::numbersOf(k));
        return result;
    }
    std::vector<Key> channels[kChannels];
    std::map<float, size_t> rows; // and how many keys are on each
    for (int c = 0; c < kChannels; ++c) {
        channels[c] = edited(first + (size_t)c);
        std::map<float, size_t> mine;
        for (const Key &k : channels[c]) rows[k.row] = std::max(rows[k.row], ++mine[k.row]);
    }
    for (auto &[row, times] : rows)
        for (size_t n = 0; n < times; ++n) result.push_back({row, 0, 0, 0, 0, 0, 0, 0, 0});
    for (size_t c = 0; c < kChannels; ++c) {
        std::vector<CameraKey> path;
        for (const Key &k : channels[c]) {
            path.push_back({k.row, {}, {}, 0, 0});
            (&path.back().eye.x)[c] = k.value;
        }
        size_t next = 0;
        for (KeyNumbers &key : result) {
            while (next < path.size() && path[next].row < key[0]) ++next;
            bool has = next < path.size() && path[next].row == key[0];
            CameraKey at = has ? path[next++] : pose({path.data(), (int)path.size()}, (double)key[0]);
            key[c + 1] = (&at.eye.x)[c];
        }
    }
    for (KeyNumbers &key : result) key = hand.rounded(t, std::move(key));
    return result;
}

void Tracks::show() {
    live->replaceTables(nullptr, 0);
    replaced.clear();
    keys.clear();
    poses.clear();
    unsavedByEditor = 0;
    for (size_t i = 0; i < tables.size(); ++i) {
        const Table &t = tables[i];
        if (!edited(t, i)) continue;
        Replaced r = {t.keys, {}, {}};
        std::vector<Key> &track = keys.emplace_back();
        std::vector<CameraKey> &path = poses.emplace_back();
        std::vector<KeyNumbers> now = contents(i);
        unsavedByEditor += now != hand.keys(t);
        for (const KeyNumbers &k : now)
            if (t.camera)
                path.push_back(maker::cameraKeyOf(k));
            else
                track.push_back(maker::keyOf(k));
        r.track = {track.data(), (int)track.size()};
        for (CameraPath &channel : r.channels)
            if (t.camera) channel = {path.data(), (int)path.size()};
        replaced.push_back(r);
    }
    live->replaceTables(replaced.data(), (int)replaced.size());
}

std::string Tracks::save(std::string &news) {
    std::string wrong;
    for (size_t i = 0; i < tables.size(); ++i) {
        const Table &t = tables[i];
        if (!edited(t, i)) continue;
        size_t first = firstOf(i);
        std::vector<KeyNumbers> now = contents(i);
        if (now == hand.keys(t)) continue; // edited by hand alone, or an editor has what the film has
        std::string why = hand.whyNot(t);
        bool foreign = !t.camera && std::any_of(now.begin(), now.end(), [](const KeyNumbers &k) {
            return maker::keyOf(k).interpolation >= kStep;
        });
        if (foreign) why = "the film has no steps and ramps: choose linear or smooth";
        if (why.empty())
            hand.change(t, std::move(now));
        else
            wrong += (wrong.empty() ? "not saved: " : "; ") + names()[first] + ": " + why;
    }
    std::string unwritten = hand.save(news);
    if (!wrong.empty() && !unwritten.empty()) wrong += "; ";
    show();
    return wrong + unwritten;
}

} // namespace odraz

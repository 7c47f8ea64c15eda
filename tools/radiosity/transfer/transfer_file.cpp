// Reads and writes room files: a line that names the kind, a checksum, and arrays (solution/arrays.h).
#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/transfer/transfer_room.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

bool finite(const std::vector<float> &list) {
    return std::all_of(list.begin(), list.end(), [](float x) { return std::fabs(x) < 1e18f; });
}
bool within(const std::vector<int> &list, int least, int end) {
    return std::all_of(list.begin(), list.end(), [&](int x) { return x >= least && x < end; });
}
bool between(int x, int least, int most) { return x >= least && x <= most; }

void putClusters(std::string &to, const Clusters &c) {
    put(to, std::vector<int>{c.count, c.rank, c.columns}, c.of, c.axes, c.weights);
}

bool getClusters(std::string_view from, size_t &at, Clusters &c, size_t rows, int columns) {
    std::vector<int> sizes;
    if (!get(from, at, sizes, c.of, c.axes, c.weights) || sizes.size() != 3) return false;
    c.count = sizes[0], c.rank = sizes[1], c.columns = sizes[2];
    return between(c.count, 1, kMostClusters) && between(c.rank, 0, kMostRank) && c.columns == columns &&
           c.of.size() == rows && within(c.of, 0, c.count) && finite(c.axes) && finite(c.weights) &&
           c.axes.size() == (size_t)c.count * (size_t)(1 + c.rank) * (size_t)c.columns &&
           c.weights.size() == c.of.size() * (size_t)c.rank;
}

bool getGlossy(std::string_view from, size_t &at, GlossyChart &g, const TransferRoom &room) {
    std::vector<int> sizes;
    if (!get(from, at, sizes) || sizes.size() != 3) return false;
    g.chart = sizes[0], g.across = sizes[1], g.down = sizes[2];
    return between(g.chart, 0, (int)room.model.charts.size() - 1) && between(g.across, 1, 1024) &&
           between(g.down, 1, 1024) &&
           getClusters(from, at, g.clusters, (size_t)(g.across * g.down), room.bases() * kGlossOutputs);
}

// Whether the texels of glossy charts have the layout that showGloss() assumes.
bool glossFits(const TransferRoom &room) {
    return std::all_of(room.gloss.begin(), room.gloss.end(), [&](const GlossyChart &g) {
        const Chart &c = room.model.charts[(size_t)g.chart];
        return c.firstTexel >= 0 && (int64_t)c.firstTexel + c.texels() <= (int64_t)room.texels();
    });
}

bool getRoom(const std::string &from, size_t &at, TransferRoom &room) {
    std::vector<int> numbers;
    std::string_view names;
    std::vector<float> polish;
    if (!get(from, at, numbers, names, polish) || numbers.size() != 4 ||
        !between(numbers[0], 1, kMostBands) || !between(numbers[1], 0, 1) ||
        !between(numbers[2], 0, kMaxLamps) || !between(numbers[3], 0, kMostGlossyCharts) ||
        polish.size() != 1 || !(polish[0] >= 0 && polish[0] <= 1))
        return false;
    room.bands = numbers[0], room.upIsZ = numbers[1], room.polish = polish[0];
    for (size_t begin = 0, end; begin < names.size(); begin = end + 1) {
        end = names.find('\0', begin);
        if (end == names.npos) return false;
        room.lamps.emplace_back(names.substr(begin, end - begin));
    }
    if (room.lamps.size() != (size_t)numbers[2] || !room.model.get(from, at) ||
        !get(from, at, room.lampOf, room.planes) || room.lampOf.size() != room.model.charts.size() ||
        !within(room.lampOf, -1, numbers[2]) || room.texels() > 1u << 27 ||
        room.planes.size() != (size_t)room.bases() * 3 * room.stride() || !finite(room.planes) ||
        !getClusters(from, at, room.clusters, room.texels(), room.columns()))
        return false;
    room.gloss.resize((size_t)numbers[3]);
    for (GlossyChart &g : room.gloss)
        if (!getGlossy(from, at, g, room)) return false;
    return at == from.size() && glossFits(room);
}

} // namespace

std::vector<float> TransferRoom::rows() const {
    auto width = (size_t)columns();
    std::vector<float> all(texels() * width);
    for (int k = 0; k < bases(); ++k)
        for (int c = 0; c < 3; ++c)
            for (size_t t = 0; t < texels(); ++t) all[t * width + (size_t)(3 * k + c)] = plane(k, c)[t];
    return all;
}

void TransferRoom::save(const std::string &path) const {
    std::string body, names; // `names`: each followed by a 0
    for (const std::string &name : lamps) names.append(name.c_str(), name.size() + 1);
    put(body, std::vector<int>{bands, upIsZ, (int)lamps.size(), (int)gloss.size()}, names,
        std::vector<float>{polish});
    model.put(body);
    put(body, lampOf, planes), putClusters(body, clusters);
    for (const GlossyChart &g : gloss)
        put(body, std::vector<int>{g.chart, g.across, g.down}), putClusters(body, g.clusters);
    common::writeWhole(path, withChecksum(kTransferMagic, body));
}

bool TransferRoom::is(const std::string &path) {
    try {
        return common::readStart(path, sizeof kTransferMagic - 1) == kTransferMagic;
    } catch (const common::Refused &) {
        return false; // read() reports why
    }
}

TransferRoom TransferRoom::read(const std::string &path) {
    std::string all = common::readWhole(path);
    size_t at = bodyOf(all, kTransferMagic);
    if (!at) throw std::runtime_error(path + ": was not written by 'radiosity transfer'");
    TransferRoom room;
    if (at == std::string::npos || !getRoom(all, at, room))
        throw std::runtime_error(path +
                                 ": is damaged, or from another version: run 'radiosity transfer' again");
    return room;
}

} // namespace odraz::radiosity

#include "tools/radiosity/transfer/relight_options.h"

#include "tools/common/text.h"
#include "tools/radiosity/solve/terminal.h"
#include "tools/radiosity/transfer/find_transfer.h"

#include <algorithm>
#include <cstdio>

namespace odraz::radiosity {

namespace {

constexpr char kGroup[] = "Light in a room that transfer wrote";

// Reads --lamps: all, none, or a list of numbers or names of lamps, each with or without =STRENGTH.
std::vector<float> readLamps(const std::string &text, const TransferRoom &room) {
    size_t count = room.lamps.size();
    if (text.empty() || text == "all") return std::vector<float>(count, 1.f);
    std::vector<float> strengths(count);
    if (text == "none") return strengths;
    for (size_t at = 0, end; at <= text.size(); at = end + 1) {
        end = std::min(text.find(',', at), text.size());
        const std::string item = text.substr(at, end - at), name = item.substr(0, item.find('='));
        size_t lamp = 0;
        while (lamp < count && name != room.lamps[lamp]) ++lamp;
        for (size_t k = 0; lamp == count && k < count; ++k)
            if (name == std::to_string(k + 1)) lamp = k;
        if (lamp == count) {
            std::string known;
            for (size_t k = 0; k < count; ++k) known += ", " + std::to_string(k + 1) + " " + room.lamps[k];
            throw common::Refused("--lamps: there is no lamp '" + name + "'; the room has " +
                                  (count ? known.substr(2) : "none"));
        }
        strengths[lamp] = name == item ? 1
                                       : (float)common::numberOf("--lamps NAME=STRENGTH",
                                                                 item.substr(name.size() + 1), {0, 1e6});
    }
    return strengths;
}

} // namespace

void RelightOptions::addTo(common::CommandLine &line, bool withSky) {
    line.group(kGroup);
    if (withSky)
        line.option("--sky", "R,G,B|FILE", sky,
                    "the light from outside; the share of a picture's energy that the bands lose is printed");
    line.option("--turn", "DEGREES", turn, {-36000, 36000},
                "rotate the sky about the axis that points up, from -z (+y if z is up) towards +x");
    line.option("--tilt", "DEGREES", tilt, {-90, 90},
                "then rotate it about x, which moves the middle of the picture upwards");
    line.option("--lamps", "LIST", lamps,
                "all, none, or a list of lamps by number or name, such as 1,3=0.5; by default all");
    line.option("--bands", "N", bands, {1, kMostBands}, "use only the first N bands");
    line.option("--rank", "N", rank, {0, kMostRank},
                "show the clusters with N axes each, instead of the exact rows");
    line.option("--clusters", "K", clusters, {1, kMostClusters},
                "find K new clusters, and show them with --rank axes each");
}

void RelightOptions::refuseFor(const std::string &path, const common::CommandLine &line) {
    if (auto given = line.givenOf({kGroup}); !given.empty())
        throw common::Refused(given[0].option + " is for a room that `radiosity transfer` wrote, and " +
                              path + " is not one");
}

Lighting RelightOptions::of(const TransferRoom &room, Projected *projectedSky) const {
    common::need(bands <= room.bands, "--bands: the room has " + common::counted((size_t)room.bands, "band"));
    common::need(rank <= room.clusters.rank, "--rank: the room's clusters have " +
                                                 common::counted((size_t)room.clusters.rank, "axis", "axes"));
    Lighting light = {{}, readLamps(lamps, room), bands ? bands : room.bands, rank};
    if (clusters && rank < 0) light.rank = room.clusters.rank;
    std::vector<std::string> notes;
    Projected projected;
    if (!sky.empty())
        projected = readEnvironment(sky, room.upIsZ, &notes);
    else if (room.lamps.empty())
        projected = project(Rgb{1, 1, 1});
    if (!sky.empty() && projected.held[0] < 1)
        std::printf("%s\n", bandLossText(sky.substr(sky.rfind('/') + 1), projected, light.bands).c_str());
    printNotes(notes);
    light.sky = turnedSky(projected.light, room, turn, tilt);
    if (projectedSky) *projectedSky = projected;
    return light;
}

void RelightOptions::changeClusters(TransferRoom &room, Workers &workers) const {
    if (!clusters || clusters == room.clusters.count) return;
    common::need((size_t)clusters <= room.texels(),
                 "--clusters: the room has " + std::to_string(room.texels()) + " texels");
    room.clusters = clustersOf(room, clusters, room.clusters.rank, workers);
}

Solution readLit(const std::string &path, const RelightOptions &options, const common::CommandLine &line,
                 Workers &workers, const EyeFor &eyeFor) {
    if (!TransferRoom::is(path)) {
        RelightOptions::refuseFor(path, line);
        Solution solution(path);
        if (eyeFor) eyeFor(solution, nullptr);
        return solution;
    }
    TransferRoom room = TransferRoom::read(path);
    options.changeClusters(room, workers);
    Lighting lighting = options.of(room);
    Vec3 eye = eyeFor ? eyeFor(room.model, &room) : Vec3{};
    return litModel(room, lighting, eyeFor ? &eye : nullptr);
}

} // namespace odraz::radiosity

#include "tools/radiosity/view/relit_room.h"

#include "tools/common/text.h"
#include "tools/radiosity/transfer/find_transfer.h"
#include "tools/support/machine.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

namespace odraz::radiosity {

RelitRoom::RelitRoom(TransferRoom given, const RelightOptions &options, void (*wake)())
    : room(std::move(given)), options(options), relighter(room), around(options.turn), tilt(options.tilt),
      lit(room.model), clusters(room.clusters), requested(clusters.count), wake(wake) {
    lighting = options.of(room, &sky);
    strengths = lighting.lamps;
    for (float &s : strengths) s = s > 0 ? s : 1;
    lastRank = lighting.rank >= 0 ? lighting.rank : clusters.rank;
    shown = std::make_shared<const ViewMesh>(lit);
}

// Finds the requested clusters on another thread.
void RelitRoom::findOthers() {
    std::packaged_task<Clusters()> task([this, count = requested] {
        Workers serial = serialWorkers(); // the other threads draw
        return clustersOf(room, count, room.clusters.rank, serial);
    });
    finding = requested, found = task.get_future();
    finder = std::jthread([task = std::move(task), wake = wake]() mutable { task(), wake(); });
}

// Takes the clusters that were found. Keeps the present ones, with a note, if they could not be found.
void RelitRoom::takeOthers() {
    try {
        clusters = found.get();
        changed = true;
    } catch (const std::exception &e) {
        const char *why = dynamic_cast<const std::bad_alloc *>(&e) ? "there is not enough memory" : e.what();
        std::fprintf(stderr, "radiosity: cannot find %s: %s; keeping the %d\n",
                     common::counted((size_t)finding, "cluster").c_str(), why, clusters.count);
        if (requested == finding) requested = clusters.count;
    }
}

bool RelitRoom::key(int key, bool shift) {
    auto toggle = [&](int lamp) {
        if (lamp < (int)room.lamps.size()) {
            float &strength = lighting.lamps[(size_t)lamp];
            strength = strength > 0 ? 0.f : strengths[(size_t)lamp];
        }
    };
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) // 0 comes after 9
        toggle((key == GLFW_KEY_0 ? 9 : key - GLFW_KEY_1) + (shift ? 10 : 0));
    else if (key == GLFW_KEY_LEFT_BRACKET || key == GLFW_KEY_RIGHT_BRACKET)
        lighting.bands = std::clamp(lighting.bands + (key == GLFW_KEY_LEFT_BRACKET ? -1 : 1), 1, room.bands);
    else if (key == GLFW_KEY_MINUS || key == GLFW_KEY_EQUAL) {
        lastRank = std::clamp(lastRank + (key == GLFW_KEY_MINUS ? -1 : 1), 0, room.clusters.rank);
        lighting.rank = lastRank;
    } else if (key == GLFW_KEY_P)
        lighting.rank = lighting.rank < 0 ? lastRank : -1;
    else if (key == GLFW_KEY_COMMA || key == GLFW_KEY_PERIOD) {
        requested = std::clamp(key == GLFW_KEY_COMMA ? requested / 2 : requested * 2, 1,
                               (int)std::min(room.texels(), (size_t)kMostClusters));
        lighting.rank = lastRank;
    } else
        return false;
    return changed = true;
}

void RelitRoom::turn(double by, double up) {
    around = std::fmod(around + by, 360), tilt = std::clamp(tilt + up, -90., 90.);
    changed = true;
}

const std::vector<Rgb> *RelitRoom::light(const Vec3 &eye) {
    if (found.valid() && found.wait_for(std::chrono::seconds(0)) == std::future_status::ready) takeOthers();
    if (!found.valid() && requested != clusters.count) findOthers();
    bool moved = !room.gloss.empty() && length(eye - lastEye) > 0;
    if (!changed && !moved) return nullptr;
    lighting.sky = turnedSky(sky.light, room, around, tilt);
    relighter.show(clusters, lighting, &eye, lit);
    points = shown->light(lit);
    changed = false, lastEye = eye;
    return &points;
}

std::string RelitRoom::title() const {
    std::string on, all = common::format("turn %ld  tilt %ld  %s  ", std::lround(around), std::lround(tilt),
                                         common::counted((size_t)lighting.bands, "band").c_str());
    if (lighting.rank < 0)
        all += "exact rows";
    else
        common::append(all, "%s of %s%s", common::counted((size_t)clusters.count, "cluster").c_str(),
                       common::counted((size_t)lighting.rank, "axis", "axes").c_str(),
                       requested != clusters.count ? ", finding others" : "");
    for (size_t k = 0; k < lighting.lamps.size(); ++k)
        if (lighting.lamps[k] > 0) on += " " + std::to_string(k + 1);
    return lighting.lamps.empty() ? all : all + "  lamps" + (on.empty() ? " off" : on);
}

std::string RelitRoom::commandOptions() const {
    std::string all, lamps;
    if (!options.sky.empty()) all += " --sky " + common::shellWord(options.sky);
    common::append(all, " --turn %g --tilt %g --bands %d", around, tilt, lighting.bands);
    if (lighting.rank >= 0) common::append(all, " --clusters %d --rank %d", clusters.count, lighting.rank);
    for (size_t k = 0; k < lighting.lamps.size(); ++k)
        if (float strength = lighting.lamps[k]; strength > 0)
            common::append(lamps, strength == 1 ? ",%zu" : ",%zu=%g", k + 1, (double)strength);
    return lighting.lamps.empty() ? all : all + " --lamps " + (lamps.empty() ? "none" : lamps.substr(1));
}

} // namespace odraz::radiosity

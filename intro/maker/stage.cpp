#include "maker/stage.h"

#include <cmath>
#include <cstring>

namespace odraz::maker {

static uint64_t hallHash(const Live &live) {
    MappedArena memory(live.hallHashMemory);
    return memory.arena.base ? live.hallHash(memory.arena) : 0;
}

Stage::Stage(std::string file) : object(std::move(file)) {
    now.live = openLive(object, wrong);
    if (now.live) useLive(now.live, nullptr);
}
void Stage::settle(int w, int h, int count, bool silent) {
    width = w;
    height = h;
    threads = count;
    mute = silent;
}

const char *Stage::load(Loaded &to, const Gl &gl, const Progress &report) {
    IntroSettings settings = {.width = width, .height = height, .hall = true};
    Workers &workers = to.pool->workers();
    to.intro = nullptr;
    to.memory = MappedArena(to.live->memoryNeeded(settings, workers.count));
    if (!to.memory.arena.base) return "not enough memory: try a smaller --size";
    return to.live->load(to.intro, settings, to.memory.arena, workers, kDrawnHemicubes, &gl, report);
}

// Loads the music and seeks to a block. The music thread may still be rendering a block of the previous
// music, whose memory therefore stays until the next change.
Sound *Stage::newSound(Loaded &to, int block) {
    if (mute) return to.sound = nullptr;
    sounds[0] = std::move(sounds[1]);
    sounds[1] = MappedArena(to.live->soundMemory());
    to.sound = sounds[1].arena.base ? to.live->loadSound(sounds[1].arena) : nullptr;
    if (to.sound) to.live->seekSound(*to.sound, block);
    return to.sound;
}

void Stage::loadOnThread(Loaded &to, const Gl &gl, const Current &current) {
    progress = 0;
    to.memory = {};
    to.pool = std::make_unique<Pool>(threads);
    loading = std::thread([this, &to, &gl, current] {
        current(true);
        Progress report = {[](float part, void *at) { *(std::atomic<float> *)at = part; }, &progress};
        loadError = load(to, gl, report);
        current(false);
        done = true;
    });
}

const char *Stage::loadFirst(const Gl &gl, uint64_t solvers, const Current &current,
                             const std::function<bool(float)> &wait) {
    now.solvers = solvers;
    now.hall = hallHash(*now.live);
    loadOnThread(now, gl, current);
    while (!done)
        if (!wait(progress)) now.pool->abort();
    loading.join();
    done = false;
    if (!now.intro) return loadError;
    if (loadError) wrong = loadError;
    useLive(now.live, newSound(now, 0));
    return nullptr;
}

void Stage::giveUp() {
    if (!loading.joinable()) return;
    next.pool->abort();
    loading.join();
    done = false;
}

void Stage::change(const Gl &gl, uint64_t solvers, int block, const Current &current) {
    giveUp(); // a load in progress loads an older film
    wrong.clear();
    const Live *live = openLive(object, wrong);
    if (!live) return;
    uint64_t hall = hallHash(*live);
    if (solvers == now.solvers && hall == now.hall &&
        !std::memcmp(live->sizes, now.live->sizes, sizeof live->sizes)) {
        now.live = live;
        useLive(live, newSound(now, block));
        return;
    }
    next.live = live;
    next.solvers = solvers;
    next.hall = hall;
    loadOnThread(next, gl, current);
}

bool Stage::poll(int block) {
    if (!done.exchange(false)) return false;
    loading.join();
    if (loadError) wrong = loadError;
    if (!next.intro) return false;
    std::swap(now, next);
    useLive(now.live, newSound(now, block));
    return true;
}

std::string Stage::state() const {
    if (!wrong.empty() || !isLoading()) return wrong;
    std::string line =
        next.hall == now.hall && next.solvers == now.solvers ? "loading the film" : "solving the hall";
    line += " again: " + std::to_string(std::lround(progress * 100)) + " of 100";
    return line;
}

} // namespace odraz::maker

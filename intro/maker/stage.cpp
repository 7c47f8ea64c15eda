#include "maker/stage.h"

#include "host/threads.h"

#include <cstdio>
#include <cstring>
#include <sys/mman.h>

namespace odraz {

namespace {

const int kNever = 0;

Arena takeArena(size_t bytes) {
    void *memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return {memory == MAP_FAILED ? nullptr : (unsigned char *)memory, bytes, 0};
}
void giveBack(Arena &arena) {
    if (arena.base) munmap(arena.base, arena.size);
    arena = {};
}

} // namespace

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
Stage::~Stage() {
    if (loading.joinable()) loading.join();
}

const char *Stage::load(Loaded &to, const Gl &gl, Workers &by, const Progress &report) {
    if (!by.count)
        if (const char *problem = startWorkers(by, threads, &kNever)) return problem;
    IntroSettings settings = {width, height};
    giveBack(to.arena);
    to.arena = takeArena(to.live->memoryNeeded(settings, by.count, true));
    if (!to.arena.base) return "not enough memory: try a smaller --size";
    return to.live->load(to.intro, settings, to.arena, by, &gl, report);
}

// The music of its score, ready at a block. The former one may still be in use: its memory stays.
Sound *Stage::newSound(Loaded &to, int block) {
    if (mute) return to.sound = nullptr;
    to.soundArena = takeArena(to.live->soundMemory());
    to.sound = to.soundArena.base ? to.live->loadSound(to.soundArena) : nullptr;
    if (to.sound) to.live->seekSound(*to.sound, block);
    return to.sound;
}

const char *Stage::loadFirst(const Gl &gl, uint64_t hall) {
    now.hall = hall;
    if (const char *problem = load(now, gl, workers[shown], {})) return problem;
    useLive(now.live, newSound(now, 0));
    return nullptr;
}

void Stage::change(const Gl &gl, uint64_t hall, int block, const std::function<void()> &enter) {
    if (loading.joinable()) loading.join(); // what it loads is stale
    done = false;
    wrong.clear();
    const Live *live = openLive(object, wrong);
    if (!live) return;
    if (hall == now.hall && !std::memcmp(live->sizes, now.live->sizes, sizeof live->sizes)) {
        now.live = live;
        useLive(live, newSound(now, block));
        return;
    }
    next.live = live;
    next.hall = hall;
    progress = 0;
    loading = std::thread([this, &gl, enter] {
        enter();
        Progress report = {[](float part, void *to) { *(std::atomic<float> *)to = part; }, &progress};
        missing = load(next, gl, workers[1 - shown], report);
        done = true;
    });
}

bool Stage::poll(int block) {
    if (!done.exchange(false)) return false;
    loading.join();
    if (missing) return wrong = missing, false;
    std::swap(now, next);
    shown = 1 - shown;
    useLive(now.live, newSound(now, block));
    return true;
}

std::string Stage::told() const {
    if (!wrong.empty()) return wrong;
    if (!loading.joinable()) return "";
    char line[80];
    std::snprintf(line, sizeof line, "the hall is solved anew: %.0f of 100", (double)progress * 100);
    return line;
}

} // namespace odraz

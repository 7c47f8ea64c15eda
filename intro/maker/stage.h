// The film that odraz-debug shows. A new version is loaded in the background while the old one is shown.
#pragma once

#include "base/arena.h"
#include "maker/live.h"
#include "maker/pool.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <sys/mman.h>
#include <thread>
#include <utility>

namespace odraz::maker {

// An arena that owns its memory: zeroed at first, unmapped by the destructor.
class MappedArena {
public:
    MappedArena() = default;
    explicit MappedArena(size_t bytes) {
        void *memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory != MAP_FAILED) arena = {(unsigned char *)memory, bytes, 0};
    }
    ~MappedArena() {
        if (arena.base) munmap(arena.base, arena.size);
    }
    MappedArena(MappedArena &&other) : arena(std::exchange(other.arena, {})) {}
    MappedArena &operator=(MappedArena &&other) { return std::swap(arena, other.arena), *this; }

    Arena arena = {}; // its base is null if there was not enough memory
};

class Stage {
public:
    // Opens the shared object, for live(). If that fails, problem() has the reason.
    explicit Stage(std::string object);
    ~Stage() { giveUp(); }
    // One line: why there is no film, or why its hall has no light, so that its scenes are black
    const std::string &problem() const { return wrong; }

    // Sets the size of pictures and the number of threads. `mute`: no sound.
    void settle(int width, int height, int threads, bool mute);
    using Current = std::function<void(bool)>;
    // Loads the film on a thread, which calls current(true) first, to make an OpenGL context current, and
    // current(false) at its end. Meanwhile calls wait(progress) repeatedly, with 0 .. 1; `wait` returns false
    // to give up. Returns null, or an error line if there is no film. `solvers`: a hash of the hall's solver.
    const char *loadFirst(const Gl &gl, uint64_t solvers, const Current &current,
                          const std::function<bool(float)> &wait);

    // Opens the rebuilt object. If its data have the same layout and its hall the same light, it makes the
    // next picture; else it is loaded in the background, like the first film. `block`: the music's position.
    void change(const Gl &gl, uint64_t solvers, int block, const Current &current);
    // Stops loading in the background; the context must still exist.
    void giveUp();
    // Call this once per picture. If a new film has been loaded, replaces the old one and returns true.
    bool poll(int block);

    Intro &intro() const { return *now.intro; }
    Sound *sound() const { return now.sound; }
    const Live &live() const { return *now.live; }
    // One line: an error or the progress of loading; empty if there is neither.
    std::string state() const;
    bool isLoading() const { return loading.joinable(); }
    float loaded() const { return isLoading() ? progress.load() : 0; } // 0 .. 1

private:
    struct Loaded {
        const Live *live = nullptr;
        Intro *intro = nullptr;
        Sound *sound = nullptr;
        MappedArena memory;
        // Hashes of the code that solves the hall's light and of that code's input
        uint64_t solvers = 0, hall = 0;
        std::unique_ptr<Pool> pool;
    };
    const char *load(Loaded &to, const Gl &gl, const Progress &progress);
    void loadOnThread(Loaded &to, const Gl &gl, const Current &current);
    Sound *newSound(Loaded &to, int block);

    std::string object, wrong;
    int width = 0, height = 0, threads = 1;
    bool mute = false;
    Loaded now, next;
    MappedArena sounds[2]; // memory of the previous and the current music
    std::thread loading;
    std::atomic<bool> done = false;
    std::atomic<float> progress = 0;
    const char *loadError = nullptr;
};

} // namespace odraz::maker

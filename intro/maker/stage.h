// The film as odraz-debug shows it: loaded, and loaded again in the background while the old one is shown.
#pragma once

#include "maker/live_film.h"
#include "maker/mapped_arena.h"
#include "maker/pool.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace odraz::maker {

class Stage {
public:
    // Opens the shared object, whose functions can be called from then on. If it cannot, problem() is the
    // reason.
    explicit Stage(std::string object);
    ~Stage() { giveUp(); }
    const std::string &problem() const { return wrong; }

    // The size of pictures, the number of threads; `mute`: no sound.
    void settle(int width, int height, int threads, bool mute);
    using Current = std::function<void(bool)>;
    // Loads the film on a thread, which calls current(true) first, to make another context of OpenGL current,
    // and current(false) at its end. Until then wait(share), 0 .. 1, is called repeatedly; it returns false
    // to give up. Returns null, or what is missing, as a line. `solvers`: a hash of the code that solves the
    // hall.
    const char *loadFirst(const Gl &gl, uint64_t solvers, const Current &current,
                          const std::function<bool(float)> &wait);

    // Opens the object that was built. If its data have the same layout and the hall the same light, the next
    // picture is of it; else it is loaded in the background, as above. `block`: where the music is.
    void change(const Gl &gl, uint64_t solvers, int block, const Current &current);
    // Stops loading in the background; the context must still exist.
    void giveUp();
    // Called once a picture: takes over what was loaded in the background. True if there is a new film.
    bool poll(int block);

    Intro &intro() const { return *now.intro; }
    Sound *sound() const { return now.sound; }
    const Live &live() const { return *now.live; }
    // The progress in the background, or what went wrong, as one line; or empty.
    std::string state() const;
    bool loads() const { return loading.joinable(); }
    float loaded() const { return loads() ? progress.load() : 0; } // 0 .. 1

private:
    struct Loaded {
        const Live *live = nullptr;
        Intro *intro = nullptr;
        Sound *sound = nullptr;
        MappedArena memory;
        uint64_t solvers = 0, hall = 0; // hashes of the code that solves the hall's light, and of its input
        std::unique_ptr<Pool> pool;
    };
    const char *load(Loaded &to, const Gl &gl, const Progress &progress);
    void loadOnThread(Loaded &to, const Gl &gl, const Current &current);
    Sound *newSound(Loaded &to, int block);

    std::string object, wrong;
    int width = 0, height = 0, threads = 1;
    bool mute = false;
    Loaded now, next;
    MappedArena sounds[2]; // of the previous music, and of the current one
    std::thread loading;
    std::atomic<bool> done = false;
    std::atomic<float> progress = 0;
    const char *missing = nullptr;
};

} // namespace odraz::maker

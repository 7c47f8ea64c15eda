// The film as odraz-debug shows it: loaded, and loaded again in the background while the former is shown.
#pragma once

#include "base/parallel.h"
#include "maker/live_film.h"

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace odraz {

class Stage {
public:
    // Opens the shared object, whose functions can be called from then on; problem() says why not.
    explicit Stage(std::string object);
    ~Stage();
    const std::string &problem() const { return wrong; }

    // What pictures and sound are to be like.
    void settle(int width, int height, int threads, bool mute);
    // Loads the film and waits. Returns null, or a line that says what is missing. A context of OpenGL must
    // be current. `hall`: a hash of what makes the hall's light.
    const char *loadFirst(const Gl &gl, uint64_t hall);

    // Takes the object that was built. Where its data are laid out as before and the hall's light is the
    // same, the next picture is of it. If not, it is loaded in the background, on a thread that runs `enter`
    // first to make another context current. `block`: where the music is.
    void change(const Gl &gl, uint64_t hall, int block, const std::function<void()> &enter);
    // Once a picture: takes what was loaded in the background. True if there is a new film.
    bool poll(int block);

    Intro &intro() const { return *now.intro; }
    Sound *sound() const { return now.sound; }
    // What goes on in the background, or what went wrong, as one line; empty if there is nothing to tell.
    std::string told() const;

private:
    struct Loaded {
        const Live *live = nullptr;
        Intro *intro = nullptr;
        Sound *sound = nullptr;
        Arena arena = {}, soundArena = {};
        uint64_t hall = 0;
    };
    const char *load(Loaded &to, const Gl &gl, Workers &workers, const Progress &progress);
    Sound *newSound(Loaded &to, int block);

    std::string object, wrong;
    int width = 0, height = 0, threads = 1;
    bool mute = false;
    Workers workers[2] = {}; // of the film that is shown, and of the next one
    int shown = 0;
    Loaded now, next;
    std::thread loading;
    std::atomic<bool> done = false;
    std::atomic<float> progress = 0;
    const char *missing = nullptr;
};

} // namespace odraz

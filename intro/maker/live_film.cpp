#include "maker/live_film.h"

#include <atomic>
#include <dlfcn.h>
#include <filesystem>
#include <unistd.h>

namespace odraz {

namespace {

// Both at once, for the music's thread
struct InUse {
    const Live *live;
    Sound *sound;
};
std::atomic<InUse *> theUse;
const Live &live() { return *theUse.load()->live; }

} // namespace

const Live *openLive(const std::string &file, std::string &wrong, std::vector<Symbol> *symbols) {
    // The loader takes two files of one name for the same: give it a copy that has a name of its own
    static int copies = 0;
    std::string copy = file + "." + std::to_string(getpid()) + "." + std::to_string(++copies);
    std::error_code error;
    if (!std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing, error))
        return wrong = "cannot copy " + file + ": " + error.message(), nullptr;
    void *object = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
    auto get = object ? (GetLive *)dlsym(object, kGetLive) : nullptr;
    if (!get) wrong = dlerror();
    if (get && symbols) *symbols = readSymbols(copy, kGetLive, (void *)get);
    std::filesystem::remove(copy, error); // it stays in memory
    return get ? get() : nullptr;
}

void useLive(const Live *next, Sound *sound) { theUse = new InUse{next, sound}; } // the former may be in use
const Live *liveInUse() { return &live(); }
const Backstage &backstage() { return live().backstage(); }

bool needsHall(double from, double to) { return live().needsHall(from, to); }
size_t memoryNeeded(const IntroSettings &s, int workers, bool hall) {
    return live().memoryNeeded(s, workers, hall);
}
const char *load(Intro *&intro, const IntroSettings &settings, Arena &arena, Workers &workers, const Gl *gl,
                 const Progress &progress) {
    return live().load(intro, settings, arena, workers, gl, progress);
}
double duration() { return live().duration(); }
int sceneAt(double seconds) { return live().sceneAt(seconds); }
const char *sceneName(int scene) { return live().sceneName(scene); }
Pace paceOf(int scene) { return live().paceOf(scene); }
CameraKey cameraAt(double seconds) { return live().cameraAt(seconds); }
Picture picture(Intro &intro, int slot, double seconds, const Quality &quality, const CameraKey *camera,
                TracedSize traced) {
    return live().picture(intro, slot, seconds, quality, camera, traced);
}
Picture between(Intro &intro, int earlier, int later, double share, int place) {
    return live().between(intro, earlier, later, share, place);
}
int64_t samplesTaken(const Intro &intro) { return live().samplesTaken(intro); }
const char *outgrown(const Intro &intro) { return live().outgrown(intro); }
size_t soundMemory() { return live().soundMemory(); }
Sound *loadSound(Arena &arena) { return live().loadSound(arena); }

// The music's thread has the sound that it was started with; what plays is the newest
void seekSound(Sound &first, int block) {
    InUse *use = theUse;
    use->live->seekSound(use->sound ? *use->sound : first, block);
}
void soundBlock(Sound &first, float *stereo) {
    InUse *use = theUse;
    use->live->soundBlock(use->sound ? *use->sound : first, stereo);
}

} // namespace odraz

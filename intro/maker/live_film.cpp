#include "maker/live_film.h"

#include <atomic>
#include <dlfcn.h>
#include <filesystem>
#include <unistd.h>

namespace odraz {

namespace {

// Replaced together, for the music's thread
struct InUse {
    const maker::Live *live;
    Sound *sound;
};
std::atomic<InUse *> theUse;

} // namespace

namespace maker {

const Live *openLive(const std::string &file, std::string &wrong) {
    // The loader takes two files of one name for the same: give it a copy that has a name of its own
    static int copies = 0;
    std::string copy = file + "." + std::to_string(getpid()) + "." + std::to_string(++copies);
    std::error_code error;
    if (!std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing, error))
        return wrong = "cannot copy " + file + ": " + error.message(), nullptr;
    void *object = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
    auto get = object ? (GetLive *)dlsym(object, kGetLive) : nullptr;
    if (!get) wrong = dlerror();
    std::filesystem::remove(copy, error); // it stays in memory
    return get ? get() : nullptr;
}

// The previous one is kept, since it may be in use.
void useLive(const Live *next, Sound *sound) { theUse = new InUse{next, sound}; }

const Inspector &inspector() { return theUse.load()->live->inspector(); }

} // namespace maker

#define FILM(type, name, parameters, arguments)                                                              \
    type name parameters { return theUse.load()->live->name arguments; }
// The music's thread has the sound that it was started with; what plays is the newest
#define SOUND(type, name, parameters, arguments)                                                             \
    type name parameters {                                                                                   \
        InUse *use = theUse;                                                                                 \
        Sound &sound = use->sound ? *use->sound : first;                                                     \
        return use->live->name arguments;                                                                    \
    }
ODRAZ_SEAM(FILM, SOUND)

} // namespace odraz

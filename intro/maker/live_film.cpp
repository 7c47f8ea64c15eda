#include "maker/live.h"

#include <atomic>
#include <dlfcn.h>
#include <filesystem>
#include <unistd.h>

namespace odraz {

namespace {

// The film and music in use, replaced together: the music thread never gets a Sound of another film
struct InUse {
    const maker::Live *live;
    Sound *sound;
};
std::atomic<InUse *> theUse;

} // namespace

namespace maker {

const Live *openLive(const std::string &file, std::string &wrong) {
    // dlopen() does not load a file name twice: open a copy with a new name
    static int copies = 0;
    std::string copy = file + "." + std::to_string(getpid()) + "." + std::to_string(++copies);
    std::error_code error;
    if (!std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing, error))
        return wrong = "cannot copy " + file + ": " + error.message(), nullptr;
    void *object = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
    auto get = object ? (GetLive *)dlsym(object, kGetLive) : nullptr;
    if (!get) wrong = dlerror();
    std::filesystem::remove(copy, error); // the mapping stays
    return get ? get() : nullptr;
}

// The previous InUse is kept, since another thread may be using it.
void useLive(const Live *next, Sound *sound) { theUse = new InUse{next, sound}; }

const Inspector &inspector() { return theUse.load()->live->inspector(); }

} // namespace maker

#define FILM(type, name, parameters, arguments)                                                              \
    type name parameters { return theUse.load()->live->name arguments; }
// The music thread passes the Sound that it was started with; the newest one plays
#define SOUND(type, name, parameters, arguments)                                                             \
    type name parameters {                                                                                   \
        InUse *use = theUse;                                                                                 \
        Sound &sound = use->sound ? *use->sound : first;                                                     \
        return use->live->name arguments;                                                                    \
    }
ODRAZ_SEAM(FILM, SOUND)

} // namespace odraz

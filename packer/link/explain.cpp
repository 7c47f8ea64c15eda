// Turns the linker's messages into one line with advice.
#include "packer/link/linker.h"

#include <dlfcn.h>
#include <set>
#include <sstream>

namespace pack::linking {

namespace {

// Advice for a missing name, by its prefix.
const char *libraryOf(const std::string &name) {
    static const struct {
        const char *begins, *advice;
    } kKnown[] = {
        {"_Z", "for C++, --cc g++ or the library's -l"},
        {"__cxa_", "for C++, --cc g++"},
        {"__gxx_", "for C++, --cc g++"},
        {"Mix_", "-lSDL2_mixer"},
        {"IMG_", "-lSDL2_image"},
        {"TTF_", "-lSDL2_ttf"},
        {"SDL_", "-lSDL2"},
        {"glu", "-lGLU"},
        {"glfw", "-lglfw"},
        {"glew", "-lGLEW"},
        {"gl", "-lGL"},
        {"egl", "-lEGL"},
        {"snd_", "-lasound"},
        {"pa_", "-lpulse"},
        {"X", "-lX11"},
        {"pthread_", "-pthread"},
        {"dl", "-ldl"},
    };
    static void *maths = dlopen("libm.so.6", RTLD_LAZY);
    if (maths && dlsym(maths, name.c_str())) return "-lm";
    for (auto &known : kKnown)
        if (name.rfind(known.begins, 0) == 0) return known.advice;
    return "the -l of the library that has it";
}

// The text between two others, or "".
std::string between(const std::string &line, const std::string &before, const std::string &after) {
    size_t from = line.find(before);
    if (from == std::string::npos) return "";
    from += before.size();
    size_t to = line.find(after, from);
    return to == std::string::npos ? "" : line.substr(from, to - from);
}

std::string explainMissing(const std::string &name, size_t others) {
    if (name == "main") return "no object has main(), which a program starts with";
    std::string more = others ? ", nor " + std::to_string(others) + " more" : "";
    return "no object or library has '" + name + "'" + more + ": add " + libraryOf(name);
}

} // namespace

std::string explainLink(const std::string &messages, bool isStatic) {
    std::set<std::string> missing;
    std::string first, any;
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        std::string name = between(line, "undefined reference to `", "'"),
                    library = between(line + "\n", "cannot find -l", "\n"),
                    twice = between(line, "multiple definition of `", "'");
        if (!library.empty())
            return "there is no library for -l" + library.substr(0, library.find(':')) + " that " +
                   (isStatic ? "can be linked statically (.a)"
                             : "can be linked: install its -dev package, or "
                               "name its folder with -L");
        if (twice == "_start") return "an object has _start: pack-link adds its own; begin with main()";
        if (!twice.empty()) return "'" + twice + "' is defined twice: " + line;
        if (!name.empty() && missing.insert(name).second && first.empty()) first = name;
        bool warns = line.find("warning: ") != std::string::npos;
        if (any.empty() && !warns && line.find(": ") != std::string::npos) any = line;
    }
    if (!first.empty()) return explainMissing(first, missing.size() - 1);
    return "it cannot be linked: " + (any.empty() ? messages : any);
}

} // namespace pack::linking

#include "host/library.h"

// The program's only two imports. They are called through the GOT, so that ld.so fills in two words and
// nothing else.
extern "C" {
__attribute__((noplt)) void *dlopen(const char *name, int mode);
__attribute__((noplt)) void *dlsym(void *library, const char *name);
}

namespace odraz {

const char *loadFunctions(const char *soname, const char *names, void **table) {
    void *library = dlopen(soname, 2 /* RTLD_NOW */);
    if (!library) return soname;
    for (const char *name = names; *name; name = nextName(name))
        if (!(*table++ = dlsym(library, name))) return name;
    return nullptr;
}

const char *fillGl(void *(*find)(const char *), Gl &gl) {
    return fillFunctions(find, ODRAZ_GL(ODRAZ_NAME), (void **)&gl);
}

} // namespace odraz

#include "host/library.h"

#include "host/windows/calls.h"

namespace odraz {

const char *loadFunctions(const char *file, const char *names, void **table) {
    void *library = LoadLibraryA(file);
    if (!library) return file;
    for (const char *name = names; *name; name = nextName(name))
        if (!(*table++ = GetProcAddress(library, name))) return name;
    return nullptr;
}

const char *fillGl(void *(*find)(const char *), Gl &gl) {
    for (int i = 0; i < windows::kGlFunctions; ++i) ((void **)&gl)[i] = odrazGlCalls + 8 * i;
    return fillFunctions(find, ODRAZ_GL(ODRAZ_NAME), odrazFunctions.gl);
}

} // namespace odraz

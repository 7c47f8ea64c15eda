// Shared libraries, opened by name when they are needed: a missing one is a sentence, not a loader's error.
#pragma once

#include "base/gl.h"

#include <stddef.h>

namespace odraz {

// Fills table[] with the functions of library `soname`, named one after the other in `names` (each with its
// zero, an empty one at the end). Returns null, or the name of what is missing: the library or a function.
const char *loadFunctions(const char *soname, const char *names, void **table);

// In such a list.
inline const char *nextName(const char *name) {
    while (*name++) {
    }
    return name;
}

// The same, from an already known way to find a function.
const char *findFunctions(void *(*find)(const char *), const char *names, void **table);

// The table of OpenGL, from a context's way to find its functions. glClipControl may be missing.
const char *findGl(void *(*find)(const char *), Gl &gl);

// For tables written as lists: #define LIST(F) F(first) F(second)
#define ODRAZ_MEMBER(name) decltype(&::name) name;
#define ODRAZ_NAME(name) #name "\0"

} // namespace odraz

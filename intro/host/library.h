// Opens shared libraries by name when they are needed. So a missing library gives a readable line instead of
// an error of the loader.
#pragma once

#include "base/gl.h"

#include <stddef.h>

namespace odraz {

// Fills table[] with functions of the library `soname`, or with those of libc if it is null. `names` is the
// list of their names: each name ends with a zero, and the list ends with an empty name. Returns null, or the
// missing library or function.
const char *loadFunctions(const char *soname, const char *names, void **table);

// Returns the name that follows `name` in such a list.
inline const char *nextName(const char *name) {
    while (*name++) {
    }
    return name;
}

// Fills table[] by `find`, which returns a function by its name. Returns null, or the name that is missing.
const char *fillFunctions(void *(*find)(const char *), const char *names, void **table);

// Fills the table of OpenGL by `find`, for the current context. Returns null, or the name that is missing.
const char *fillGl(void *(*find)(const char *), Gl &gl);

// For tables written as lists: #define LIST(F) F(first) F(second)
#define ODRAZ_MEMBER(name) decltype(&::name) name;
#define ODRAZ_NAME(name) #name "\0"

} // namespace odraz

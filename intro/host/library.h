// Shared libraries, opened by name when they are needed, so that a missing one gives a readable line instead
// of a loader's error.
#pragma once

#include "base/gl.h"

#include <stddef.h>

namespace odraz {

// Fills table[] with functions of the library `soname`. `names` holds their names one after the other, each
// ending with a zero, and an empty name at the end. Returns null, or the name of what is missing: the library
// or a function.
const char *loadFunctions(const char *soname, const char *names, void **table);

// The name that follows in such a list.
inline const char *nextName(const char *name) {
    while (*name++) {
    }
    return name;
}

// The same, where `find` looks up a function by its name.
const char *findFunctions(void *(*find)(const char *), const char *names, void **table);

// Fills the table of OpenGL; `find` looks up a function of the current context.
const char *findGl(void *(*find)(const char *), Gl &gl);

// For tables written as lists: #define LIST(F) F(first) F(second)
#define ODRAZ_MEMBER(name) decltype(&::name) name;
#define ODRAZ_NAME(name) #name "\0"

} // namespace odraz

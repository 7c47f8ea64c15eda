#include "host/library.h"

namespace odraz {

const char *fillFunctions(void *(*find)(const char *), const char *names, void **table) {
    for (const char *name = names; *name; name = nextName(name))
        if (!(*table++ = find(name))) return name;
    return nullptr;
}

} // namespace odraz

#include "base/arena.h"

namespace odraz {

void *Arena::take(size_t count, size_t each) {
    size_t start = (used + 63) & ~(size_t)63;
    if (start > size || count > (size - start) / each) {
        full = true;
        return nullptr;
    }
    used = start + count * each;
    return base + start;
}

} // namespace odraz

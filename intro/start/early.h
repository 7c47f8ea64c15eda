// What runs while the packed program is still being decoded: the window opens, and its bar grows.
#pragma once

#include "host/window.h"

namespace odraz {

struct Early {
    int64_t began; // when, in nanoseconds(); 0 if the program was not packed
    bool opened;   // the window is open; if not, main opens it
    FilmWindow window;
    int viewerLeft;        // set by the window
    int closedDescriptors; // what prepareDescriptors found
};
extern Early theEarly; // zero at first; not part of what is decoded

inline bool viewerLeft() { return __atomic_load_n(&theEarly.viewerLeft, __ATOMIC_RELAXED) != 0; }

constexpr float kEarlyShare = 0.4f; // of all loading

} // namespace odraz

// Called by the packer's stub: first when this function and all that it uses have been decoded (early.ld
// lists that), then every few milliseconds. `stack`: as the kernel made it. `done` of `size` bytes are
// decoded.
extern "C" void odrazEarly(void **stack, uint32_t done, uint32_t size);

// The part that runs while the rest of the packed program is decoded: it opens the window and draws its bar.
#pragma once

#include "host/window.h"

namespace odraz {

struct Early {
    int64_t began; // the program's start, in nanoseconds(); 0 if it was not packed
    bool opened;   // whether the window is open; if not, main opens it
    FilmWindow window;
    int viewerLeft;        // set by the window
    int closedDescriptors; // the result of prepareDescriptors()
};
extern Early theEarly; // starts as zero, and is not decoded

inline bool viewerLeft() { return __atomic_load_n(&theEarly.viewerLeft, __ATOMIC_RELAXED) != 0; }

constexpr float kEarlyShare = 0.4f; // the decoding's share of all loading

} // namespace odraz

// The packer's stub calls this function as soon as it and all that it uses (listed in early.ld) are decoded,
// and then every few milliseconds. `stack` is the kernel's: argc, then argv. `done` of `size` bytes are
// decoded.
extern "C" void odrazEarly(void **stack, uint32_t done, uint32_t size);

// What the stub calls while the rest is being decoded, in place of the film's.
#include "start/early.h"

#include "../probe.h"

namespace probe {
Early theEarly; // zero at first; outside of what is decoded
}

extern "C" void odrazEarly(void **stack, uint32_t done, uint32_t size) {
    probe::Early &e = probe::theEarly;
    e.off |= probe::stackIsOff();
    e.wrong |= done < e.last || done > size || (e.calls && size != e.size);
    e.last = done;
    e.size = size;
    e.arguments = (int)(long)stack[0];
    ++e.calls;
}

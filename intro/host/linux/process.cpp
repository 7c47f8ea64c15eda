#include "host/process.h"

#include "film.h"
#include "host/linux/sys.h"

namespace odraz {

// The duplicate of standard error while a Quiet exists, otherwise 0. It cannot be initialised to 2: when the
// early part prints an error, only data that is initialised to 0 exists
static long theStandardError;

const char kMoreMemory[] = "end other programs, or raise ulimit -v";

void *takeMemory(size_t bytes) { return sys::map(bytes, sys::kReadWrite); }

void giveBack(void *memory, size_t bytes) {
    long from = ((long)memory + 4095) & -4096;
    sys::call(sys::kMadvise, from, ((long)memory + (long)bytes - from) & -4096, 4 /* not needed */);
}

static bool mayMap(size_t bytes, sys::Protection protection) {
    void *memory = sys::map(bytes, protection);
    if (memory) sys::call(sys::kMunmap, (long)memory, (long)bytes);
    return memory;
}

const char *jitForbidden() {
    return mayMap(4096, sys::kReadWriteExecute)
               ? nullptr
               : "MemoryDenyWriteExecute or SELinux forbids code that OpenGL generates: allow it";
}

bool couldAddress(size_t bytes) { return mayMap(bytes, sys::kNothing); }

int printError(const char *line) {
    char text[512] = FILM_NAME ": ";
    int size = sizeof FILM_NAME + 1;
    // Keep the message to one line, even if it quotes control characters that a user gave
    for (; *line && size < 510; ++line) text[size++] = (uint8_t)*line < ' ' ? '?' : *line;
    text[size++] = '\n';
    sys::call(sys::kWrite, theStandardError ? theStandardError : 2, (long)text, size);
    return 1;
}

Quiet::Quiet() {
    long duplicate = sys::call(sys::kFcntl, 2, 1030 /* F_DUPFD_CLOEXEC */, 3),
         nothing = sys::call(sys::kOpen, (long)"/dev/null", 0x80002 /* O_RDWR, cloexec */);
    if (duplicate >= 0 && nothing >= 0) { // else libraries still print
        sys::call(sys::kDup2, nothing, 2);
        theStandardError = duplicate;
    } else {
        sys::call(sys::kClose, duplicate);
    }
    sys::call(sys::kClose, nothing);
}

Quiet::~Quiet() {
    if (!theStandardError) return;
    sys::call(sys::kDup2, theStandardError, 2);
    sys::call(sys::kClose, theStandardError);
    theStandardError = 0;
}

int prepareDescriptors() {
    int closed = 0;
    for (int fd = 0; fd < 3; ++fd)
        if (sys::call(sys::kFcntl, fd, 1 /* F_GETFD */) == -sys::kEbadf) {
            closed |= 1 << fd;
            // The new descriptor gets the lowest free number, which is fd
            sys::call(sys::kOpen, (long)"/dev/null", 2 /* O_RDWR */);
        }
    uint64_t action[4] = {1 /* SIG_IGN */};
    sys::call(sys::kSigaction, 13 /* SIGPIPE */, (long)action, 0, 8);
    sys::call(sys::kSigaction, 25 /* SIGXFSZ */, (long)action, 0, 8);
    return closed;
}

void endProcess(int status) { sys::exit(status); }

} // namespace odraz

#include "host/process.h"

#include "host/linux/sys.h"

namespace odraz {

void *takeMemory(size_t bytes) { return sys::map(bytes, sys::kReadWrite); }

int complain(const char *line) {
    char text[512] = "odraz: ";
    int size = 7;
    while (*line && size < 510) text[size++] = *line++;
    text[size++] = '\n';
    sys::call(sys::kWrite, 2, (long)text, size);
    return 1;
}

int prepareDescriptors() {
    int closed = 0;
    for (int fd = 0; fd < 3; ++fd)
        if (sys::call(sys::kFcntl, fd, 1 /* F_GETFD */) == -sys::kEbadf) {
            closed |= 1 << fd;
            sys::call(sys::kOpen, (long)"/dev/null",
                      2 /* O_RDWR */); // takes the lowest free number: this one
        }
    uint64_t action[4] = {1 /* SIG_IGN */};
    sys::call(sys::kSigaction, 13 /* SIGPIPE */, (long)action, 0, 8);
    sys::call(sys::kSigaction, 25 /* SIGXFSZ */, (long)action, 0, 8);
    return closed;
}

void endProcess(int status) { sys::exit(status); }

} // namespace odraz

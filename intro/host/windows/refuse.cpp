#include "host/library.h"
#include "host/process.h"
#include "host/windows/calls.h"

namespace odraz {

// In a box only where nobody sees standard error: no script that has it shall wait for a viewer.
int refuse(const char *line) {
    complain(line);
    if (!GetFileType(windows::standard(2)) &&
        !loadFunctions("user32.dll", ODRAZ_USER32(ODRAZ_NAME), odrazFunctions.user32))
        MessageBoxA(nullptr, line, "odraz", 0x10 /* an error's sign */);
    return 1;
}

} // namespace odraz

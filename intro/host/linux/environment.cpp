#include "host/environment.h"

#include "base/text.h"
#include "host/library.h"

namespace odraz {

const char *causeOf(const char *texts, const char *only) {
    static char text[512];
    AnyText line = {text, sizeof text};
    const char *(*getenv)(const char *);
    loadFunctions(nullptr, "getenv\0", (void **)&getenv);
    line << texts;
    if (only && *only) line << ", only " << only;
    line << ": ";
    const char *fault = nextName(texts), *variable = fault;
    const char *value;
    do {
        variable = nextName(variable);
        if (!*variable) {
            line << variable + 1;
            return text;
        }
        value = getenv(variable);
    } while (!value || !*value);
    line << variable << " is " << value << fault;
    return text;
}

} // namespace odraz

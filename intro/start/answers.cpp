#include "start/answers.h"

#include "film.h"
#include "host/process.h"
#include "output/output.h"
#include "show/length.h"
#include "timeline/track.h"
#include "version.h"

namespace odraz {

bool answered(int argc, char **argv, bool stdoutClosed, Options &o, int &status) {
    Message wrong;
    if (!parseOptions(argc, argv, kEndRow / kRowsPerSecond, o, wrong)) {
        printError(wrong.data);
        status = 2;
    } else if (stdoutClosed && (o.help || o.version || o.doctor || o.stats))
        status = cannotWrite("standard output", "it is closed");
    else if (o.help || (o.version && !o.doctor))
        status = printAnswer(o);
    else
        return false;
    return true;
}

int printAnswer(const Options &o) {
    Text<4096> t;
    if (o.help)
        writeHelp(t);
    else
        t << FILM_NAME " " ODRAZ_VERSION " " ODRAZ_COMMIT "\n";
    return writeOutput("-", t.data, (size_t)t.size);
}

} // namespace odraz

#include "maker/debug_options.h"

#include "maker/rocket/client.h"

#include <regex>

namespace odraz::maker {

// Reads HOST, HOST:PORT, [ADDRESS] or [ADDRESS]:PORT. (IPv6 addresses contain colons.)
static bool readHost(const std::string &word, std::string &host, int &port) {
    static const std::regex form(R"((?:\[([^\]]+)\]|([^:\[]+)|([^\[]*:[^\[]*:.*))(?::(\d{1,5}))?)");
    std::smatch part;
    if (!std::regex_match(word, part, form)) return false;
    host = part[1].str() + part[2].str() + part[3].str();
    port = part[4].matched ? std::stoi(part[4]) : rocket::kPort;
    return port >= 1 && port <= 65535;
}

std::string takeOptions(int &argc, char **argv, DebugOptions &to) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        bool file = word == "--shown" || word == "--tracks", last = i + 1 == argc;
        if (file && last) return word + " needs a file";
        if (file) {
            (word == "--shown" ? to.shown : to.tracks) = argv[++i];
        } else if (word == "--rocket") {
            std::string where = !last && argv[i + 1][0] != '-' && argv[i + 1][0] ? argv[++i] : "localhost";
            if (!readHost(where, to.host, to.port))
                return "cannot use '--rocket " + where +
                       "': give HOST or HOST:PORT, with a port from 1 to 65535";
        } else {
            argv[kept++] = argv[i];
        }
    }
    argc = kept;
    argv[argc] = nullptr;
    int modes = (to.shown != nullptr) + (to.tracks != nullptr) + !to.host.empty();
    return modes > 1 ? "use only one of --shown, --tracks and --rocket" : "";
}

} // namespace odraz::maker

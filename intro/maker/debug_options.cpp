#include "maker/debug_options.h"

#include "maker/rocket/client.h"

#include <algorithm>
#include <charconv>

namespace odraz::maker {

namespace {

// HOST, HOST:PORT, [ADDRESS], [ADDRESS]:PORT; an address of IPv6 has colons of its own.
bool readHost(const std::string &word, std::string &host, int &port) {
    host = word;
    port = rocket::kPort;
    size_t colon = word.rfind(':');
    bool bracket = word[0] == '[';
    size_t end = bracket ? word.find(']') : 0;
    if (bracket) {
        if (end == word.npos) return false;
        host = word.substr(1, end - 1);
        if (end + 1 == word.size()) return !host.empty();
        if (colon != end + 1) return false;
    } else {
        if (colon == word.npos || word.find(':') != colon) return true;
        host = word.substr(0, colon);
    }
    const char *last = word.data() + word.size();
    auto [at, error] = std::from_chars(word.data() + colon + 1, last, port);
    return !host.empty() && error == std::errc() && at == last && port >= 1 && port <= 65535;
}

} // namespace

std::string takeOptions(int &argc, char **argv, DebugOptions &to) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        bool file = word == "--shown" || word == "--tracks", more = i + 1 < argc;
        if (file && !more) return word + " needs a file";
        if (file) {
            (word == "--shown" ? to.shown : to.tracks) = argv[++i];
        } else if (word == "--rocket") {
            std::string where = more && argv[i + 1][0] != '-' && argv[i + 1][0] ? argv[++i] : "localhost";
            if (!readHost(where, to.host, to.port))
                return "cannot use '--rocket " + where + "': give HOST or HOST:PORT, a port up to 65535";
        } else {
            argv[kept++] = argv[i];
        }
    }
    argc = kept;
    argv[argc] = nullptr;
    int modes = (to.shown != nullptr) + (to.tracks != nullptr) + !to.host.empty();
    return modes > 1 ? "--shown, --tracks and --rocket go one at a time" : "";
}

} // namespace odraz::maker

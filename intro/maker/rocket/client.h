// A client of GNU Rocket: it offers tracks to an editor, gets their keys, and both follow one row.
//
// The protocol runs over TCP; numbers are big-endian. The client greets with 19 bytes, the editor answers
// with 12. Then come messages, each a byte for its kind, and what belongs to it:
//
//     0 SET_KEY      track, row, value (a float), interpolation (a byte)
//     1 DELETE_KEY   track, row
//     2 GET_TRACK    length of the name, name
//     3 SET_ROW      row
//     4 PAUSE        1 or 0 (a byte)
//     5 SAVE_TRACKS
//
// GET_TRACK is for the editor, which answers with the track's keys; SET_ROW goes either way; all else comes
// from the editor. Tracks are numbered in the order in which they were asked for. Rocket's editors read no
// SET_KEY: there is no way to give them a key.
#pragma once

#include "maker/rocket/track.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odraz::maker::rocket {

inline constexpr int kPort = 1338;
inline constexpr uint32_t kMostRow = 1 << 24; // larger values are refused as garbage

class Client {
public:
    // `tracks`: the names of all that are offered, as in "hall.camera:eye.x"; the part up to the colon is the
    // group.
    Client(std::string host, int port, std::vector<std::string> tracks);
    ~Client();
    Client(const Client &) = delete;

    // Does what can be done without waiting (but for looking up the name of a host): connects, again each
    // second if that fails; takes messages, and sends its own. `now`: seconds of any clock that
    // does not go back. Call it once a picture.
    void update(double now);

    bool connected() const { return state == State::Talking; }
    // Why there is no connection, as a line for the user; empty while there is one.
    const std::string &problem() const { return wrong; }
    // Changes whenever a key does.
    uint64_t version() const { return changes; }
    const Track &track(size_t i) const { return keys[i]; }

    // What the editor has sent since the last call.
    std::optional<uint32_t> takeRow() { return std::exchange(sentRow, {}); }
    std::optional<bool> takePause() { return std::exchange(sentPause, {}); }
    bool takeSave() { return std::exchange(sentSave, false); }

    // Sends the editor the film's row. A row that it knows is not sent again.
    void sendRow(uint32_t row);

private:
    enum class State { Apart, Connecting, Greeting, Talking };
    void connect();
    void drop(const std::string &why);
    void read();
    void write();
    bool greet();
    bool takeMessage();

    std::string host;
    int port;
    std::vector<std::string> names;
    std::vector<Track> keys;
    int socket = -1;
    State state = State::Apart;
    size_t unreached = 0; // connections that failed: each time another of the host's addresses comes first
    double tried = -1e9;  // when it last tried to connect
    std::string in, out, wrong;
    uint64_t changes = 0;
    std::optional<uint32_t> sentRow, knownRow;
    std::optional<bool> sentPause;
    bool sentSave = false;
};

} // namespace odraz::maker::rocket

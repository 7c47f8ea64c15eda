// Tracks of GNU Rocket, and a client that offers them to an editor and receives their keys. Both show the
// same row.
//
// The protocol runs over TCP; numbers are big-endian. The client greets with 19 bytes, and the editor answers
// with 12. Messages follow, each a byte for its kind and these fields (four bytes each, unless noted):
//
//     0 SET_KEY      track, row, value (a float), interpolation (a byte)
//     1 DELETE_KEY   track, row
//     2 GET_TRACK    length of the name, name
//     3 SET_ROW      row
//     4 PAUSE        1 or 0 (a byte)
//     5 SAVE_TRACKS
//
// The client sends GET_TRACK, and the editor answers with the track's keys. Both send SET_ROW, the editor all
// other kinds; it ignores SET_KEY, so it takes no keys. Tracks are numbered in the order of GET_TRACK.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odraz::maker::rocket {

// Kinds of interpolation between the values of a track, numbered as in the protocol.
enum class Interpolation : uint8_t {
    Step,   // constant
    Linear, // straight
    Smooth, // t^2 (3 - 2t), flat at both keys
    Ramp,   // t^2, flat at the first
};

struct Key {
    float value;
    Interpolation interpolation; // up to the next key
    bool operator==(const Key &) const = default;
};

using Track = std::map<uint32_t, Key>; // by row

// Returns tracks as a document for editors of GNU Rocket: the XML that the original editor writes, which
// emoon's editor also reads. `rows`: the document's length. Names must not contain characters that XML
// reserves (the film's have letters, digits, '.', '-' and ':').
std::string document(const std::vector<std::string> &names, const std::vector<Track> &tracks, int rows);

inline constexpr int kPort = 1338;
inline constexpr uint32_t kMostRow = 1 << 24; // larger rows are rejected as garbage

class Client {
public:
    // `tracks`: the names of all tracks, such as "hall.camera:eye.x": the group, a colon, the name.
    Client(std::string host, int port, std::vector<std::string> tracks);
    ~Client();
    Client(const Client &) = delete;

    // Call this once per picture. It connects, trying again every second, and receives and sends messages.
    // Never waits, except to look up a host's name. `now`: seconds of any clock that does not go back.
    void update(double now);

    bool connected() const { return state == State::Talking; }
    // One line: why there is no connection; empty while there is one.
    const std::string &problem() const { return wrong; }
    // Increases whenever a key changes.
    uint64_t version() const { return changes; }
    const Track &track(size_t i) const { return keys[i]; }

    // These return the editor's requests since the last call.
    std::optional<uint32_t> takeRow() { return std::exchange(sentRow, {}); }
    std::optional<bool> takePause() { return std::exchange(sentPause, {}); }
    bool takeSave() { return std::exchange(sentSave, false); }

    // Sends the film's row, unless the editor has it already.
    void sendRow(uint32_t row);

private:
    enum class State { Closed, Connecting, Greeting, Talking };
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
    State state = State::Closed;
    size_t failures = 0; // failed connections; their number selects the host's address that is tried first
    double tried = -1e9; // when it last tried to connect
    std::string in, out, wrong;
    uint64_t changes = 0;
    std::optional<uint32_t> sentRow, knownRow;
    std::optional<bool> sentPause;
    bool sentSave = false;
};

} // namespace odraz::maker::rocket

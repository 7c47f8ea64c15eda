#include "maker/rocket/client.h"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace odraz::maker::rocket {

namespace {

constexpr char kGreeting[] = "hello, synctracker!", kAnswer[] = "hello, demo!";
constexpr double kRetry = 1; // seconds between two attempts to connect
constexpr size_t kMostUnsent = 1 << 20;

enum : uint8_t { kSetKey, kDeleteKey, kGetTrack, kSetRow, kPause, kSaveTracks };
// Sizes of the editor's messages in bytes, including the kind; 0: the editor does not send this kind.
constexpr size_t kSizes[] = {14, 9, 0, 5, 2, 1};

void put(std::string &to, uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) to += (char)(number >> shift);
}
uint32_t take(const std::string &from, size_t at) {
    uint32_t number = 0;
    for (size_t i = 0; i < 4; ++i) number = number << 8 | (uint8_t)from[at + i];
    return number;
}

} // namespace

std::string document(const std::vector<std::string> &names, const std::vector<Track> &tracks, int rows) {
    char line[160];
    std::snprintf(line, sizeof line, "<sync rows=\"%d\">\n\t<tracks startRow=\"0\" endRow=\"%d\">\n", rows,
                  rows - 1);
    std::string text = line;
    for (size_t i = 0; i < names.size(); ++i) {
        text += "\t\t<track name=\"" + names[i] + "\">\n";
        for (auto &[row, key] : tracks[i]) {
            std::snprintf(line, sizeof line, "\t\t\t<key row=\"%u\" value=\"%.9g\" interpolation=\"%d\"/>\n",
                          row, (double)key.value, (int)key.interpolation);
            text += line;
        }
        text += "\t\t</track>\n";
    }
    return text + "\t</tracks>\n\t<bookmarks/>\n</sync>\n";
}

Client::Client(std::string host, int port, std::vector<std::string> tracks)
    : host(std::move(host)), port(port), names(std::move(tracks)), keys(names.size()) {}
Client::~Client() {
    if (socket >= 0) close(socket);
}

void Client::update(double now) {
    if (state == State::Closed && now >= tried + kRetry) {
        tried = now;
        connect();
    }
    if (state == State::Connecting) {
        pollfd p = {socket, POLLOUT, 0};
        if (poll(&p, 1, 0) <= 0) {
            if (now >= tried + 5 * kRetry) drop("does not answer");
            return;
        }
        int error = 0;
        socklen_t size = sizeof error;
        getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
        if (error) return drop(std::strerror(error));
        out = kGreeting;
        state = State::Greeting;
    }
    if (state != State::Closed) write();
    if (state != State::Closed) read();
    if (state == State::Greeting && now >= tried + 5 * kRetry)
        drop("does not send the greeting of GNU Rocket");
    if (state == State::Talking) write();
}

void Client::connect() {
    addrinfo hints = {}, *all = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    if (int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &all))
        return drop(gai_strerror(error));
    std::string why = "has no address";
    std::vector<addrinfo *> addresses;
    for (addrinfo *a = all; a; a = a->ai_next) addresses.push_back(a);
    for (size_t k = 0; k < addresses.size() && state == State::Closed; ++k) {
        const addrinfo *a = addresses[(failures + k) % addresses.size()];
        socket = ::socket(a->ai_family, a->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, a->ai_protocol);
        if (socket < 0) continue;
        if (::connect(socket, a->ai_addr, a->ai_addrlen) == 0 || errno == EINPROGRESS) {
            int on = 1; // send rows at once, not in full packets
            setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
            state = State::Connecting;
        } else {
            why = std::strerror(errno);
            close(socket);
            socket = -1;
        }
    }
    freeaddrinfo(all);
    if (state == State::Closed) drop(why);
}

void Client::drop(const std::string &why) {
    wrong = "no editor of GNU Rocket at " + host + ":" + std::to_string(port) + ": " + why;
    if (socket >= 0) close(socket);
    socket = -1;
    failures += state == State::Connecting;
    state = State::Closed;
    in.clear();
    out.clear();
    knownRow = {};
}

void Client::write() {
    while (!out.empty()) {
        ssize_t sent = send(socket, out.data(), out.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            if (out.size() > kMostUnsent) drop("does not receive data");
            return;
        }
        if (sent < 0) return drop(std::strerror(errno));
        out.erase(0, (size_t)sent);
    }
}

void Client::read() {
    char block[4096];
    for (;;) {
        ssize_t got = recv(socket, block, sizeof block, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
        if (got < 0) return drop(std::strerror(errno));
        if (got == 0) return drop("closed the connection");
        in.append(block, (size_t)got);
        if (state == State::Greeting && !greet()) return;
        while (state == State::Talking && takeMessage()) {
        }
        if (state == State::Closed) return;
    }
}

// Returns false if the connection was dropped.
bool Client::greet() {
    size_t size = std::min(in.size(), sizeof kAnswer - 1);
    if (in.compare(0, size, kAnswer, size)) return drop("does not send the greeting of GNU Rocket"), false;
    if (size < sizeof kAnswer - 1) return true;
    in.erase(0, size);
    state = State::Talking;
    wrong.clear();
    // The editor will send all keys again
    for (Track &t : keys) t.clear();
    ++changes;
    for (const std::string &name : names) {
        out += (char)kGetTrack;
        put(out, (uint32_t)name.size());
        out += name;
    }
    return true;
}

// Returns false if there is no complete message, or if the connection was dropped.
bool Client::takeMessage() {
    if (in.empty()) return false;
    constexpr char kGarbage[] = "sent a message that is not in the protocol";
    uint8_t kind = (uint8_t)in[0];
    if (kind >= sizeof kSizes / sizeof *kSizes || !kSizes[kind]) return drop(kGarbage), false;
    if (in.size() < kSizes[kind]) return false;
    uint32_t track = kind <= kDeleteKey ? take(in, 1) : 0, row = kind <= kDeleteKey ? take(in, 5) : 0;
    if (kind == kSetRow) row = take(in, 1);
    if ((kind <= kDeleteKey && track >= keys.size()) || row > kMostRow) return drop(kGarbage), false;
    if (kind == kSetKey) {
        float value = std::bit_cast<float>(take(in, 9));
        uint8_t interpolation = (uint8_t)in[13];
        if (!std::isfinite(value) || interpolation > (uint8_t)Interpolation::Ramp)
            return drop(kGarbage), false;
        keys[track][row] = {value, (Interpolation)interpolation};
    }
    if (kind == kDeleteKey) keys[track].erase(row);
    if (kind == kSetKey || kind == kDeleteKey) ++changes;
    if (kind == kSetRow) sentRow = knownRow = row;
    if (kind == kPause) sentPause = in[1] != 0;
    if (kind == kSaveTracks) sentSave = true;
    in.erase(0, kSizes[kind]);
    return true;
}

void Client::sendRow(uint32_t row) {
    if (state != State::Talking || knownRow == row) return;
    knownRow = row;
    out += (char)kSetRow;
    put(out, row);
    write();
}

} // namespace odraz::maker::rocket

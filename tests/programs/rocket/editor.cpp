// An editor of GNU Rocket that takes orders, for rocket.sh.
//   rocket_editor
// Listens on a free port of 127.0.0.1, and prints "port N". A film that connects must send the
// protocol's greeting; then its messages are printed, a line each: "track NAME", "row N". Orders are lines on
// standard input:
//   key NAME ROW VALUE INTERPOLATION   sets a key
//   delete NAME ROW
//   row N | pause 0 | pause 1 | save
//   open FILE                          sends all keys of a document
//   garbage                            sends what is not in the protocol
//   hang-up
#include <arpa/inet.h>
#include <bit>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <poll.h>
#include <sstream>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace {

std::string number(uint32_t n) { return {(char)(n >> 24), (char)(n >> 16), (char)(n >> 8), (char)n}; }

class Editor {
public:
    int listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), film = -1;

    bool begin() {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (bind(listening, (sockaddr *)&address, size) || listen(listening, 1)) return false;
        getsockname(listening, (sockaddr *)&address, &size);
        print("port " + std::to_string(ntohs(address.sin_port)));
        return true;
    }
    void acceptFilm() {
        if (film >= 0) close(film);
        film = accept(listening, nullptr, nullptr);
        received.clear();
        tracks.clear();
        greeted = false;
    }
    void receive() {
        char block[4096];
        ssize_t got = recv(film, block, sizeof block, 0);
        if (got <= 0) return hangUp();
        received.append(block, (size_t)got);
        if (!greeted && received.size() >= 19) {
            print(received.substr(0, 19) == "hello, synctracker!" ? "film" : "stranger");
            received.erase(0, 19);
            greeted = true;
            sendBytes("hello, demo!");
        }
        while (greeted && takeMessage()) {
        }
    }
    void hangUp() {
        if (film >= 0) close(film), print("gone");
        film = -1;
    }
    void perform(const std::string &line) {
        std::istringstream in(line);
        std::string what, name;
        uint32_t row = 0, kind = 0;
        float value = 0;
        in >> what;
        if (what == "key" && in >> name >> row >> value >> kind) sendKey(name, row, value, kind);
        if (what == "delete" && in >> name >> row) sendBytes('\1' + number(tracks.at(name)) + number(row));
        if (what == "row" && in >> row) sendBytes('\3' + number(row));
        if (what == "pause" && in >> row) sendBytes(std::string("\4") + (char)row);
        if (what == "save") sendBytes("\5");
        if (what == "open" && in >> name) open(name);
        if (what == "garbage") sendBytes("\x7f and so on");
        if (what == "hang-up") hangUp();
    }

private:
    static void print(const std::string &line) { std::cout << line << std::endl; }
    void sendBytes(const std::string &bytes) {
        if (film >= 0 && send(film, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) hangUp();
    }
    void sendKey(const std::string &name, uint32_t row, float value, uint32_t kind) {
        if (tracks.count(name))
            sendBytes(std::string(1, '\0') + number(tracks[name]) + number(row) +
                      number(std::bit_cast<uint32_t>(value)) + (char)kind);
    }
    void open(const std::string &file) {
        std::ifstream in(file);
        char name[200] = {};
        for (std::string line; std::getline(in, line);) {
            unsigned row, kind;
            float value;
            std::sscanf(line.c_str(), " <track name=\"%199[^\"]", name);
            if (std::sscanf(line.c_str(), " <key row=\"%u\" value=\"%f\" interpolation=\"%u", &row, &value,
                            &kind) == 3)
                sendKey(name, row, value, kind);
        }
    }
    uint32_t numberAt(size_t at) const {
        uint32_t n = 0;
        for (size_t i = 0; i < 4; ++i) n = n << 8 | (uint8_t)received[at + i];
        return n;
    }
    bool takeMessage() {
        if (received.size() < 5) return false;
        uint32_t n = numberAt(1);
        if (received[0] == '\3') {
            print("row " + std::to_string(n));
            received.erase(0, 5);
            return true;
        }
        if (received[0] != '\2') return print("nonsense"), hangUp(), false;
        if (received.size() < 5 + n) return false;
        std::string name = received.substr(5, n);
        received.erase(0, 5 + n);
        tracks.emplace(name, (uint32_t)tracks.size());
        print("track " + name);
        return true;
    }

    std::string received;
    std::map<std::string, uint32_t> tracks;
    bool greeted = false;
};

} // namespace

int main() {
    Editor editor;
    if (!editor.begin()) return std::perror("rocket_editor"), 1;
    for (std::string typed;;) {
        pollfd all[] = {{0, POLLIN, 0}, {editor.listening, POLLIN, 0}, {editor.film, POLLIN, 0}};
        if (poll(all, 3, -1) < 0) continue;
        if (all[2].revents) editor.receive();
        if (all[1].revents) editor.acceptFilm();
        if (!all[0].revents) continue;
        char block[512];
        ssize_t got = read(0, block, sizeof block);
        if (got <= 0) return 0;
        typed.append(block, (size_t)got);
        for (size_t end; (end = typed.find('\n')) != typed.npos; typed.erase(0, end + 1))
            editor.perform(typed.substr(0, end));
    }
}

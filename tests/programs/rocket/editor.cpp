// An editor of GNU Rocket that does as it is told, for rocket.sh.
//   rocket_editor
// Listens on a free port of 127.0.0.1, and prints "port N". A film that comes must greet as the protocol
// says; then its messages are printed, a line each: "track NAME", "row N". Lines on standard input tell what
// to do:
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
        tell("port " + std::to_string(ntohs(address.sin_port)));
        return true;
    }
    void meet() {
        if (film >= 0) close(film);
        film = accept(listening, nullptr, nullptr);
        heard.clear();
        tracks.clear();
        greeted = false;
    }
    void hear() {
        char block[4096];
        ssize_t got = recv(film, block, sizeof block, 0);
        if (got <= 0) return hangUp();
        heard.append(block, (size_t)got);
        if (!greeted && heard.size() >= 19) {
            tell(heard.substr(0, 19) == "hello, synctracker!" ? "film" : "stranger");
            heard.erase(0, 19);
            greeted = true;
            say("hello, demo!");
        }
        while (greeted && takeMessage()) {
        }
    }
    void hangUp() {
        if (film >= 0) close(film), tell("gone");
        film = -1;
    }
    void obey(const std::string &line) {
        std::istringstream in(line);
        std::string what, name;
        uint32_t row = 0, kind = 0;
        float value = 0;
        in >> what;
        if (what == "key" && in >> name >> row >> value >> kind) sayKey(name, row, value, kind);
        if (what == "delete" && in >> name >> row) say('\1' + number(tracks.at(name)) + number(row));
        if (what == "row" && in >> row) say('\3' + number(row));
        if (what == "pause" && in >> row) say(std::string("\4") + (char)row);
        if (what == "save") say("\5");
        if (what == "open" && in >> name) open(name);
        if (what == "garbage") say("\x7f and so on");
        if (what == "hang-up") hangUp();
    }

private:
    static void tell(const std::string &line) { std::cout << line << std::endl; }
    void say(const std::string &bytes) {
        if (film >= 0 && send(film, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) hangUp();
    }
    void sayKey(const std::string &name, uint32_t row, float value, uint32_t kind) {
        if (tracks.count(name))
            say(std::string(1, '\0') + number(tracks[name]) + number(row) +
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
                sayKey(name, row, value, kind);
        }
    }
    uint32_t numberAt(size_t at) const {
        uint32_t n = 0;
        for (size_t i = 0; i < 4; ++i) n = n << 8 | (uint8_t)heard[at + i];
        return n;
    }
    bool takeMessage() {
        if (heard.size() < 5) return false;
        uint32_t n = numberAt(1);
        if (heard[0] == '\3') {
            tell("row " + std::to_string(n));
            heard.erase(0, 5);
            return true;
        }
        if (heard[0] != '\2') return tell("nonsense"), hangUp(), false;
        if (heard.size() < 5 + n) return false;
        std::string name = heard.substr(5, n);
        heard.erase(0, 5 + n);
        tracks.emplace(name, (uint32_t)tracks.size());
        tell("track " + name);
        return true;
    }

    std::string heard;
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
        if (all[2].revents) editor.hear();
        if (all[1].revents) editor.meet();
        if (!all[0].revents) continue;
        char block[512];
        ssize_t got = read(0, block, sizeof block);
        if (got <= 0) return 0;
        typed.append(block, (size_t)got);
        for (size_t end; (end = typed.find('\n')) != typed.npos; typed.erase(0, end + 1))
            editor.obey(typed.substr(0, end));
    }
}

#include "maker/edits.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace odraz::maker {

namespace {

constexpr double kGreets = 0.3; // seconds in which an editor sends the keys that it has

} // namespace

Edits::Edits(std::string show, std::string name, int number)
    : host(std::move(name)), port(number), tracks(std::move(show)) {}

void Edits::find(const Stage &stage) {
    if (found) return;
    found = true;
    std::vector<std::string> before = tracks.names();
    tracks.find(stage.live());
    if (host.empty() || (client && tracks.names() == before)) return;
    client =
        std::make_unique<rocket::Client>(host, port, tracks.names()); // other tracks, another conversation
    version = 0;
}

Edits::Requests Edits::update(const Stage &stage, double now, double row) {
    Requests requests;
    if (host.empty() && tracks.names().empty()) return requests; // nothing was ever edited
    find(stage);
    if (!client) return requests;
    client->update(now);
    if (client->connected() != connected) {
        connected = client->connected();
        since = now;
        if (connected) requests.message = "an editor of GNU Rocket is there";
    }
    if (!connected && client->problem() != problem) requests.message = client->problem();
    problem = client->problem();
    // At first it has none, and sends what it has at once: until then the film stays as it is
    if (connected && now >= since + kGreets && client->version() != version) {
        version = client->version();
        for (size_t i = 0; i < tracks.names().size(); ++i) tracks.takeFromEditor(i, client->track(i));
        tracks.show();
    }
    if (auto to = client->takeRow()) requests.row = *to;
    requests.pause = client->takePause();
    requests.save = client->takeSave();
    if (!requests.row) client->sendRow((uint32_t)std::fmax(std::floor(row), 0));
    return requests;
}

uint32_t Edits::setView(const Stage &stage, double row, const CameraKey *camera, std::string &message) {
    find(stage);
    uint32_t at = tracks.rowOfView(row);
    std::string why = tracks.setView(at, camera), done = camera ? "set" : "removed";
    message = why.empty() ? "key " + done + (camera ? " on " : " from ") + tracks.rowInWords(at)
                          : "no key " + done + ": " + why;
    return at;
}
void Edits::undo(const Stage &stage, std::string &message) {
    find(stage);
    message = tracks.undo() ? "undone" : "nothing to undo";
    tracks.show();
    if (!tracks.unsavedByHand()) found = false; // the files are read again: somebody may have changed them
}
void Edits::redo(const Stage &stage, std::string &message) {
    find(stage);
    message = tracks.redo() ? "done again" : "nothing to do again";
    tracks.show();
}
std::string Edits::save(const Stage &stage, std::string &message) {
    find(stage);
    return tracks.save(message);
}

std::string Edits::writeDocument(const Stage &stage, const std::string &file, std::string &message) {
    find(stage);
    std::vector<rocket::Track> all;
    for (size_t i = 0; i < tracks.names().size(); ++i) all.push_back(tracks.track(i));
    int rows = (int)std::ceil(stage.live().duration() * kRowsPerSecond);
    std::string text = rocket::document(tracks.names(), all, rows + 1), beside = file + ".new";
    std::ofstream out(beside, std::ios::binary);
    out << text;
    out.close();
    std::error_code error;
    if (out) std::filesystem::rename(beside, file, error);
    message = std::to_string(all.size()) + " tracks in " + file;
    if (int off = tracks.offRows())
        message += "; " + std::to_string(off) +
                   " keys of the film are between rows, before row 0 or two on a row: "
                   "they are on the nearest one, or left out";
    if (out && !error) return "";
    std::string why = error ? error.message() : std::strerror(errno);
    std::filesystem::remove(beside, error);
    return "cannot write " + file + ": " + why;
}

} // namespace odraz::maker

#include "maker/edits.h"

#include "tools/common/whole_file.h"

#include <cmath>

namespace odraz::maker {

static constexpr double kSettling = 0.3; // seconds that a new editor gets to send its keys

Edits::Edits(const Stage &shown, std::string show, std::string name, int number)
    : stage(shown), host(std::move(name)), port(number), tracks(std::move(show)) {
    renew();
}

void Edits::renew() {
    std::vector<std::string> before = tracks.names();
    tracks.readFilm(stage.live());
    if (host.empty() || (client && tracks.names() == before)) return;
    // A connection's list of tracks is fixed: connect again
    client = std::make_unique<rocket::Client>(host, port, tracks.names());
    version = 0;
}

Edits::Requests Edits::update(double now, double row) {
    Requests requests;
    if (!client) return requests;
    client->update(now);
    if (client->connected() != connected) {
        connected = client->connected();
        since = now;
        if (connected) requests.message = "connected to an editor of GNU Rocket";
    }
    if (!connected && client->problem() != problem) requests.message = client->problem();
    problem = client->problem();
    // A new editor seems to have no keys until the first ones have arrived
    if (connected && now >= since + kSettling && client->version() != version) {
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

uint32_t Edits::setView(double row, const CameraKey *camera, std::string &message) {
    uint32_t at = tracks.rowOfView(row);
    std::string why = tracks.setView(at, camera), done = camera ? "set" : "removed";
    message = why.empty() ? "key " + done + (camera ? " on " : " from ") + tracks.rowInWords(at)
                          : "no key " + done + ": " + why;
    return at;
}
std::string Edits::undo() {
    bool undone = tracks.undo();
    tracks.show();
    if (!tracks.unsavedByHand()) renew(); // reads the files again, which somebody may have changed
    return undone ? "undone" : "nothing to undo";
}
std::string Edits::redo() {
    bool done = tracks.redo();
    tracks.show();
    return done ? "redone" : "nothing to redo";
}
std::string Edits::save() {
    std::string message, wrong = tracks.save(message);
    return wrong.empty() ? message : wrong;
}

std::string Edits::writeDocument(const std::string &file) {
    std::vector<rocket::Track> all;
    for (size_t i = 0; i < tracks.names().size(); ++i) all.push_back(tracks.track(i));
    int rows = (int)std::ceil(stage.live().duration() * kRowsPerSecond), off = tracks.offRows();
    common::writeWhole(file, rocket::document(tracks.names(), all, rows + 1));
    std::string message = std::to_string(all.size()) + " tracks in " + file;
    if (off)
        message += "; " + std::to_string(off) +
                   " keys (between rows, below row 0, or second on a row) were moved to the nearest row or "
                   "left out";
    return message;
}

} // namespace odraz::maker

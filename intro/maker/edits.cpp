#include "maker/edits.h"

#include "tools/common/whole_file.h"

#include <cmath>

namespace odraz::maker {

namespace {

constexpr double kGreets = 0.3; // seconds in which an editor sends the keys that it has

} // namespace

Edits::Edits(const Stage &shown, std::string show, std::string name, int number)
    : stage(shown), host(std::move(name)), port(number), tracks(std::move(show)) {
    renew();
}

void Edits::renew() {
    std::vector<std::string> before = tracks.names();
    tracks.find(stage.live());
    if (host.empty() || (client && tracks.names() == before)) return;
    client =
        std::make_unique<rocket::Client>(host, port, tracks.names()); // other tracks need a new connection
    version = 0;
}

Edits::Requests Edits::update(double now, double row) {
    Requests requests;
    if (!client) return requests;
    client->update(now);
    if (client->connected() != connected) {
        connected = client->connected();
        since = now;
        if (connected) requests.message = "an editor of GNU Rocket is there";
    }
    if (!connected && client->problem() != problem) requests.message = client->problem();
    problem = client->problem();
    // A new editor sends its keys at once; before they have arrived it seems to have none
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
    if (!tracks.unsavedByHand()) renew(); // the files are read again: somebody may have changed them
    return undone ? "undone" : "nothing to undo";
}
std::string Edits::redo() {
    bool done = tracks.redo();
    tracks.show();
    return done ? "done again" : "nothing to do again";
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
                   " keys of the film are between rows, before row 0 or two on a row: they are on the "
                   "nearest one, or left out";
    return message;
}

} // namespace odraz::maker

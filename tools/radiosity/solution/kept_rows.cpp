#include "tools/radiosity/solution/kept_rows.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/solution.h"

namespace odraz {

namespace {

constexpr char kMagic[] = "odraz radiosity rows 1\n";

void put(std::string &to, const std::vector<std::string> &words) {
    odraz::put(to, std::vector<uint64_t>{words.size()});
    for (const std::string &word : words) odraz::put(to, std::vector<char>(word.begin(), word.end()));
}
bool get(std::string_view from, size_t &at, std::vector<std::string> &words) {
    std::vector<uint64_t> count;
    if (!odraz::get(from, at, count) || count.size() != 1) return false;
    for (uint64_t k = 0; k < count[0]; ++k) {
        std::vector<char> word;
        if (!odraz::get(from, at, word)) return false;
        words.emplace_back(word.begin(), word.end());
    }
    return true;
}
// Bytes as an array, of which only a view is taken when it is read.
void putBytes(std::string &to, std::string_view bytes) {
    const uint64_t head[2] = {bytes.size(), 1};
    to.append((const char *)head, sizeof head);
    to.append(bytes);
}
bool getBytes(std::string_view from, size_t &at, std::string_view &bytes) {
    uint64_t head[2];
    if (from.size() - at < sizeof head) return false;
    std::memcpy(head, from.data() + at, sizeof head);
    at += sizeof head;
    if (head[1] != 1 || head[0] > from.size() - at) return false;
    bytes = from.substr(at, head[0]);
    at += head[0];
    return true;
}

} // namespace

void KeptRows::save(const std::string &path) const {
    std::string body;
    body.reserve(rows.size() + prepared.size() + 4096);
    odraz::put(body, std::vector<uint64_t>{model, sky, solution, evenSky});
    odraz::put(body, away);
    put(body, words), put(body, names.libraries), put(body, names.asked), put(body, names.all);
    odraz::put(body, names.known), odraz::put(body, names.used);
    putBytes(body, rows), putBytes(body, prepared);
    writeWhole(path, withChecksum(kMagic, body));
}

KeptRows::KeptRows(const std::string &path) : file(readWhole(path)) {
    size_t at = bodyOf(file, kMagic);
    if (!at) throw Refused(path + ": holds no rows of 'radiosity solve --keep-rows'");
    std::vector<uint64_t> head;
    bool good = at != std::string::npos && odraz::get(file, at, head) && head.size() == 4 &&
                odraz::get(file, at, away) && away.size() == 3 && get(file, at, words) &&
                get(file, at, names.libraries) && get(file, at, names.asked) && get(file, at, names.all) &&
                odraz::get(file, at, names.known) && odraz::get(file, at, names.used) &&
                names.known.size() == names.asked.size() && names.used.size() == names.all.size() &&
                getBytes(file, at, rows) && getBytes(file, at, prepared) && at == file.size();
    if (!good) throw Refused(path + ": is damaged, or from another version: solve with --keep-rows again");
    model = head[0], sky = head[1], solution = head[2], evenSky = head[3] != 0;
}

uint64_t sumOfFile(const std::string &path) {
    std::string all = readWhole(path);
    return checksum(all.data(), all.size());
}

} // namespace odraz

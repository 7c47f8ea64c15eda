#include "tools/radiosity/solution/kept_rows.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

namespace {

constexpr char kMagic[] = "odraz radiosity rows 1\n";

// Four checksums of a word in four: the file is large, and one would wait for its own multiplications.
uint64_t sumOfLanes(std::string_view all) {
    constexpr size_t kLanes = 4, kStep = kLanes * sizeof(uint64_t);
    uint64_t sum[kLanes] = {1, 2, 3, 4}, word[kLanes];
    size_t at = 0;
    for (; at + kStep <= all.size(); at += kStep) {
        std::memcpy(word, all.data() + at, kStep);
        for (size_t k = 0; k < kLanes; ++k) {
            sum[k] = (sum[k] ^ word[k]) * 0x100000001b3u;
            sum[k] ^= sum[k] >> 29;
        }
    }
    uint64_t parts[2] = {checksum((const char *)sum, sizeof sum), checksum(all.data() + at, all.size() - at)};
    return checksum((const char *)parts, sizeof parts);
}

void put(std::string &to, const std::vector<std::string> &words) {
    radiosity::put(to, std::vector<uint64_t>{words.size()});
    for (const std::string &word : words) radiosity::put(to, std::vector<char>(word.begin(), word.end()));
}
bool get(std::string_view from, size_t &at, std::vector<std::string> &words) {
    std::vector<uint64_t> count;
    if (!radiosity::get(from, at, count) || count.size() != 1) return false;
    for (uint64_t k = 0; k < count[0]; ++k) {
        std::vector<char> word;
        if (!radiosity::get(from, at, word)) return false;
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

// A file is the line that names its kind, the checksum of the rest, and the rest.
constexpr size_t kLine = sizeof kMagic - 1, kHead = kLine + sizeof(uint64_t);

void KeptRows::save(const std::string &path) const {
    std::string all(kMagic);
    all.reserve(rows.size() + prepared.size() + 65536);
    all.resize(kHead);
    radiosity::put(all, std::vector<uint64_t>{model, sky, solution, evenSky});
    radiosity::put(all, away);
    put(all, words), put(all, names.libraries), put(all, names.asked), put(all, names.all);
    radiosity::put(all, names.known), radiosity::put(all, names.used);
    putBytes(all, prepared);
    // Rows are used where they lie: place them as their items need it
    radiosity::put(all, std::vector<char>(8 - all.size() % 8));
    putBytes(all, rows);
    uint64_t sum = sumOfLanes(std::string_view(all).substr(kHead));
    std::memcpy(&all[kLine], &sum, sizeof sum);
    common::writeWhole(path, all);
}

KeptRows::KeptRows(const std::string &path) : file(common::readWholeFile(path)) {
    std::string_view all = file.view();
    if (all.size() < kHead || all.substr(0, kLine) != kMagic)
        throw common::Refused(path + ": holds no rows of 'radiosity solve --keep-rows'");
    uint64_t sum;
    std::memcpy(&sum, &all[kLine], sizeof sum);
    size_t at = kHead;
    std::vector<uint64_t> head;
    std::vector<char> padding;
    bool good = sum == sumOfLanes(all.substr(kHead)) && radiosity::get(all, at, head) && head.size() == 4 &&
                radiosity::get(all, at, away) && away.size() == 3 && get(all, at, words) &&
                get(all, at, names.libraries) && get(all, at, names.asked) && get(all, at, names.all) &&
                radiosity::get(all, at, names.known) && radiosity::get(all, at, names.used) &&
                names.known.size() == names.asked.size() && names.used.size() == names.all.size() &&
                getBytes(all, at, prepared) && radiosity::get(all, at, padding) && getBytes(all, at, rows) &&
                at == all.size();
    if (!good)
        throw common::Refused(path + ": is damaged, or from another version: solve with --keep-rows again");
    model = head[0], sky = head[1], solution = head[2], evenSky = head[3] != 0;
}

uint64_t sumOfFile(const std::string &path) {
    std::string all = common::readWhole(path);
    return checksum(all.data(), all.size());
}

} // namespace odraz::radiosity

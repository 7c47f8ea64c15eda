#include "tools/radiosity/solution/kept.h"

#include "tools/radiosity/read/mtl_reader.h"
#include "tools/radiosity/solution/arrays.h"

#include <map>

namespace odraz::radiosity {

namespace {

// The first line of each kind of file, and the errors for another kind and for a damaged file.
constexpr struct {
    const char *magic, *other, *again;
} kKinds[] = {{"odraz radiosity state 4\n", "is not a state of 'radiosity solve' of this version",
               "solve the model again"},
              {"odraz radiosity rows 4\n", "holds no rows of 'radiosity solve --keep-rows' of this version",
               "solve with --keep-rows again"}};

void putWords(std::string &to, const std::vector<std::string> &words) {
    put(to, std::vector<uint64_t>{words.size()});
    for (const std::string &word : words) put(to, word);
}

bool getWords(std::string_view from, size_t &at, std::vector<std::string> &words) {
    std::vector<uint64_t> count;
    if (!get(from, at, count) || count.size() != 1) return false;
    for (uint64_t k = 0; k < count[0]; ++k) {
        std::string_view word;
        if (!get(from, at, word)) return false;
        words.emplace_back(word);
    }
    return true;
}

} // namespace

void Kept::save(const std::string &path, Kind kind) const {
    std::string all = kKinds[(int)kind].magic;
    const size_t sumAt = all.size(), body = sumAt + sizeof(uint64_t);
    all.reserve(rows.size() + prepared.size() + 65536);
    all.resize(body);
    put(all, std::vector<uint64_t>{model, sky, solution, evenSky}, place);
    for (const auto *list : {&words, &names.parts, &names.libraries, &names.asked, &names.all})
        putWords(all, *list);
    put(all, names.known, names.used, prepared);
    // Rows are used in place, so align them for their items
    put(all, std::string(8 - all.size() % 8, '\0'), rows);
    uint64_t sum = checksum(all.data() + body, all.size() - body);
    std::memcpy(&all[sumAt], &sum, sizeof sum);
    common::writeWhole(path, all);
}

Kept::Kept(const std::string &path, Kind kind) : file(common::readWholeFile(path)) {
    std::string_view all = file.view();
    size_t at = bodyOf(all, kKinds[(int)kind].magic);
    if (!at) throw common::Refused(path + ": " + kKinds[(int)kind].other);
    std::vector<uint64_t> head;
    std::string_view padding;
    bool good = at != std::string::npos && get(all, at, head, place) && head.size() == 4 &&
                (kind == Kind::kState || place.size() == 1);
    for (auto *list : {&words, &names.parts, &names.libraries, &names.asked, &names.all})
        good = good && getWords(all, at, *list);
    good = good && get(all, at, names.known, names.used, prepared, padding, rows) && at == all.size() &&
           names.known.size() == names.asked.size() && names.used.size() == names.all.size();
    if (!good)
        throw common::Refused(path + ": is damaged, or from another version: " + kKinds[(int)kind].again);
    model = head[0], sky = head[1], solution = head[2], evenSky = head[3] != 0;
}

uint64_t sumOfFile(const std::string &path, const std::vector<std::string> &parts) {
    std::string all = common::readWhole(path);
    for (const std::string &part : parts) all += common::readWhole(findFile(folderOf(path), part));
    return checksum(all.data(), all.size());
}

uint64_t sumOf(const SkyPicture &sky) {
    return checksum((const char *)sky.pixels.data(), sky.pixels.size() * sizeof(Rgb));
}

// The checksum of a picture's file; 0 if it cannot be read.
static uint64_t sumOfPicture(const MeshPicture &p) {
    try {
        return p.bytes ? checksum(p.bytes->data(), p.bytes->size()) : sumOfFile(p.path);
    } catch (const common::Refused &) {
        return 0;
    }
}

uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky) {
    std::string all;
    std::map<std::string, uint64_t> pictures;
    put(all, mesh.points), put(all, std::vector<Vec3>{mesh.place});
    for (const Triangle &t : mesh.triangles) {
        const int words[4] = {t.corners[0], t.corners[1], t.corners[2], t.material};
        all.append((const char *)words, sizeof words);
    }
    for (const MeshMaterial &m : mesh.materials) {
        all.append((const char *)m.reflects.data(), sizeof m.reflects);
        all.append((const char *)m.emits.data(), sizeof m.emits);
        const MeshPicture &p = m.picture;
        if (p.path.empty()) continue;
        auto [known, fresh] = pictures.try_emplace(p.path, 0);
        if (fresh) known->second = sumOfPicture(p);
        put(all, std::vector<float>{p.tint[0], p.tint[1], p.tint[2], p.scale[0], p.scale[1], p.offset[0],
                                    p.offset[1], (float)p.clamp});
        put(all, std::vector<uint64_t>{known->second});
    }
    put(all, mesh.coordinates);
    put(all, sky.pixels, mesh.lights.suns, mesh.lights.lamps);
    return checksum(all.data(), all.size());
}

} // namespace odraz::radiosity

#include "tools/radiosity/solution/solve_state.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/arrays.h"

#include <map>

namespace odraz::radiosity {

namespace {

constexpr char kMagic[] = "odraz radiosity state 1\n";

} // namespace

void SolveState::save(const std::string &path) const {
    std::string body;
    put(body, std::vector<uint64_t>{model, words.size()});
    for (const std::string &word : words) put(body, std::vector<char>(word.begin(), word.end()));
    body += rows;
    common::writeWhole(path, withChecksum(kMagic, body));
}

SolveState SolveState::read(const std::string &path) {
    std::string all = common::readWhole(path);
    size_t at = bodyOf(all, kMagic);
    if (!at) throw common::Refused(path + ": is not a state of 'radiosity solve'");
    SolveState s;
    std::vector<uint64_t> head;
    bool good = at != std::string::npos && get(all, at, head) && head.size() == 2;
    for (uint64_t k = 0; good && k < head[1]; ++k) {
        std::vector<char> word;
        good = get(all, at, word);
        s.words.emplace_back(word.begin(), word.end());
    }
    if (!good) throw common::Refused(path + ": is damaged, or from another version: solve the model again");
    s.model = head[0];
    s.rows = all.substr(at);
    return s;
}

uint64_t sumOf(const SkyPicture &sky) {
    return checksum((const char *)sky.pixels.data(), sky.pixels.size() * sizeof(Rgb));
}

// The checksum of a picture's file; 0 if it cannot be read.
static uint64_t sumOfPicture(const std::string &path) {
    try {
        std::string all = common::readWhole(path);
        return checksum(all.data(), all.size());
    } catch (const common::Refused &) {
        return 0;
    }
}

uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky) {
    std::string all;
    std::map<std::string, uint64_t> pictures;
    put(all, mesh.points);
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
        if (fresh) known->second = sumOfPicture(p.path);
        put(all, std::vector<float>{p.tint[0], p.tint[1], p.tint[2], p.scale[0], p.scale[1], p.offset[0],
                                    p.offset[1], (float)p.clamp});
        put(all, std::vector<uint64_t>{known->second});
    }
    put(all, mesh.coordinates);
    put(all, sky.pixels);
    return checksum(all.data(), all.size());
}

} // namespace odraz::radiosity

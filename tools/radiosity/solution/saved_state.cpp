#include "tools/radiosity/solution/saved_state.h"

#include "tools/radiosity/solution/arrays.h"

#include <map>

namespace odraz::radiosity {

static constexpr char kStateMagic[] = "odraz radiosity state 7\n";

void SavedState::save(const std::string &path) const {
    std::string body;
    body.reserve(rows.size() + 65536);
    put(body, std::vector<uint64_t>{model, words.size()});
    for (const std::string &word : words) put(body, word);
    put(body, rows);
    common::writeWhole(path, withChecksum(kStateMagic, body));
}

SavedState::SavedState(const std::string &path) : file(common::readWhole(path)) {
    std::string_view all = file;
    size_t at = bodyOf(all, kStateMagic);
    if (!at) throw common::Refused(path + ": is not a state of 'radiosity solve' of this version");
    std::vector<uint64_t> head;
    bool good = at != std::string::npos && get(all, at, head) && head.size() == 2;
    while (good && words.size() < head[1]) {
        std::string_view word;
        good = get(all, at, word);
        words.emplace_back(word);
    }
    if (!good || !get(all, at, rows) || at != all.size())
        throw common::Refused(path + ": is damaged, or from another version: solve the model again");
    model = head[0];
}

// The checksum of a picture file; 0 if it cannot be read.
static uint64_t sumOfPicture(const MeshPicture &p) {
    try {
        const std::string all = p.bytes ? *p.bytes : common::readWhole(p.path);
        return checksum(all.data(), all.size());
    } catch (const common::Refused &) {
        return 0;
    }
}

uint64_t sumOf(const Mesh &mesh, const SkyPicture &sky) {
    std::string all;
    std::map<std::string, uint64_t> pictures;
    put(all, mesh.points), put(all, std::vector<Vec3>{mesh.origin});
    for (const Triangle &t : mesh.triangles) {
        const int words[] = {t.corners[0], t.corners[1], t.corners[2], t.material, t.object};
        all.append((const char *)words, sizeof words);
    }
    for (const MeshMaterial &m : mesh.materials) {
        all.append((const char *)m.reflects.data(), sizeof m.reflects);
        all.append((const char *)m.emits.data(), sizeof m.emits);
        const MeshPicture &p = m.picture;
        if (p.path.empty()) continue;
        auto [entry, added] = pictures.try_emplace(p.path, 0);
        if (added) entry->second = sumOfPicture(p);
        put(all, std::vector<float>{p.tint[0], p.tint[1], p.tint[2], p.scale[0], p.scale[1], p.offset[0],
                                    p.offset[1], (float)p.clamp});
        put(all, std::vector<uint64_t>{entry->second});
    }
    put(all, mesh.coordinates);
    put(all, sky.pixels, mesh.lights.suns, mesh.lights.lamps);
    return checksum(all.data(), all.size());
}

} // namespace odraz::radiosity

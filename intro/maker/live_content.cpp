// The functions that the shared object has in addition to the engine.
#include "inside.h"
#include "maker/live.h"
#include "tools/common/hash.h"

namespace odraz::maker {

namespace {

struct Hash {
    uint64_t value = common::kFnvStart;
    template <class T> void add(const T *data, int count = 1) {
        for (int i = 0; i < count; ++i) {
            T copy = data[i];
            __builtin_clear_padding(&copy); // copying leaves garbage in the padding
            value = common::fnv1a({(const char *)&copy, sizeof copy}, value);
        }
    }
};

// Hashes the used elements of the arrays, but no addresses; nothing if the hall has nothing to solve
template <class AnyHall> void add(Hash &hash, const AnyHall &hall, const Scene &scene) {
    if constexpr (requires { hall.radiosity.bases; }) {
        hash.add(hall.model.charts, hall.model.chartCount);
        hash.add(hall.model.facets, hall.model.facetCount);
        hash.add(scene.mean, scene.materialCount);
        const auto &bases = hall.radiosity.bases;
        for (int count : {bases.skyCount, bases.sunCount, bases.lampCount}) hash.add(&count);
        hash.add(bases.suns, bases.sunCount);
        hash.add(bases.lamps, bases.lampCount);
        auto settings = hallSettings(hall);
        hash.add(&settings);
    }
}
uint64_t hallHash(Arena &arena) {
    Hall *hall = arena.allocate<Hall>(1);
    Scene *scene = arena.allocate<Scene>(1);
    if (arena.full) return 0;
    prepareHall(*hall, *scene);
    Hash hash;
    add(hash, *hall, *scene);
    return hash.value;
}

KeyTable *keyTables() { return KeyTable::newest; }

void setKeys(KeyTable &table, const void *keys, int count) {
    __builtin_memcpy(table.keys, keys, (size_t)count * (table.camera ? sizeof(CameraKey) : sizeof(Key)));
    table.count = count;
    // Update the shots' copies of the count. Shots are not constant in the shared object (KEYED, in keys.h)
    for (int i = 0; i < kFilm.count; ++i)
        if (auto &shot = const_cast<Shot &>(kFilm.shots[i]); shot.path.keys == table.poses)
            shot.path.count = count;
}

#define FUNCTION(type, name, parameters, arguments) odraz::name,
const Live kLive = {
    ODRAZ_SEAM(FUNCTION, FUNCTION) inspector,
    hallHash,
    sizeof(Hall) + sizeof(Scene) + 4096,
    keyTables,
    setKeys,
    {sizeof(Intro), sizeof(Scene), sizeof(Hall), sizeof(Sound)},
};

} // namespace

extern "C" [[gnu::visibility("default")]] const Live *odrazLive() { return &kLive; }

} // namespace odraz::maker

namespace odraz {

float value(const KeyTable &table, float row) {
    int i = -1;
    while (i + 1 < table.count && table.keys[i + 1].row <= row) ++i;
    if (i < 0 || i + 1 == table.count || table.keys[i].interpolation < kStep)
        return value(Track{table.keys, table.count}, row);
    const Key &a = table.keys[i], &b = table.keys[i + 1];
    if (a.interpolation == kStep) return a.value;
    float t = (row - a.row) / (b.row - a.row);
    return a.value + (b.value - a.value) * t * t;
}

} // namespace odraz

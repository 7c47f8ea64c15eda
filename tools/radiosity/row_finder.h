// Who finds form factors: rows of a divided model, for the patches of which `lit` says so (form_factor.h).
#pragma once

#include "radiosity/form_factor.h"

#include <functional>
#include <vector>

namespace odraz {

// Fills `factors` with memory of the arena; `model` is posed in the scene. Where it has rows already, those
// that are known stay. False where workers.abort ended it: what there is then is whole. Throws
// std::runtime_error where memory is short.
using RowFinder =
    std::function<bool(const Model &model, const Scene &scene, const uint8_t *lit, Workers &workers,
                       Arena &arena, FormFactors &factors, const Progress &progress)>;

// Rows by hemicubes that OpenGL draws, of `px` pixels, `turns` for each patch; another `turn` turns all of
// them otherwise. Refuses at once what looks as if the arena could not hold it.
RowFinder rowsByHemicubes(const Gl &gl, int px, int turns, uint32_t turn);

// For finders of rows one by one.
struct FoundRow {
    std::vector<Link> links;
    bool known;
};
void keepRows(const std::vector<FoundRow> &rows, Arena &arena, FormFactors &factors);
// The patch at a place of a chart.
uint32_t patchAt(const Model &model, int chart, Vec3 at);

// Memory of an arena, or a line that tells how much is needed.
[[noreturn]] void refuseMemory(const Arena &arena, size_t more);
[[noreturn]] void refuseMemory(size_t bytes, size_t most, const char *remedy);
template <class T> T *takeOrRefuse(Arena &arena, size_t count) {
    if (T *p = arena.take<T>(count)) return p;
    refuseMemory(arena, count * sizeof(T));
}

} // namespace odraz

#include "radiosity/model.h"

#include <initializer_list>

namespace odraz {

int Model::addRect(const Vec3 &corner, const Vec3 &u, const Vec3 &v, int material, float cell, Kind kind) {
    Chart &c = charts[chartCount];
    c = {};
    c.corner = corner;
    c.width = length(u), c.height = length(v);
    // Divide: multiplying by the inverse would not give exactly 1 along an axis, and corners would not meet
    auto unit = [](Vec3 a, float length) { return Vec3{a.x / length, a.y / length, a.z / length}; };
    c.u = unit(u, c.width), c.v = unit(v, c.height);
    c.n = cross(c.u, c.v);
    c.material = (uint16_t)material;
    c.open = kind == kOpen;
    auto cells = [&](float side) { return (int16_t)clamp(side / cell + 0.5f, 1.f, (float)kMaxAcross); };
    c.across = cells(c.width), c.down = cells(c.height);
    c.firstFacet = facetCount;
    ++chartCount;
    if (kind != kPieces) addFacet(0, 0, c.width, c.height);
    return chartCount - 1;
}

void Model::addFacet(const float *u, const float *v) {
    Facet &f = facets[facetCount++];
    f.chart = chartCount - 1;
    for (int k = 0; k < 4; ++k) f.u[k] = u[k], f.v[k] = v[k];
    ++charts[f.chart].facetCount;
}

void Model::addBox(const Vec3 &lo, const Vec3 &hi, int material, float cell, unsigned sides) {
    Vec3 x = {hi.x - lo.x, 0, 0}, y = {0, hi.y - lo.y, 0}, z = {0, 0, hi.z - lo.z};
    struct {
        Vec3 corner, u, v;
    } const all[] = {{lo, z, y},                  // left: -x
                     {{hi.x, lo.y, hi.z}, -z, y}, // right: +x
                     {lo, x, z},                  // bottom: -y
                     {{lo.x, hi.y, hi.z}, x, -z}, // top: +y
                     {{hi.x, lo.y, lo.z}, -x, y}, // back: -z
                     {{lo.x, lo.y, hi.z}, x, y}}; // front: +z
    for (int i = 0; i < 6; ++i)
        if (sides >> i & 1) addRect(all[i].corner, all[i].u, all[i].v, material, cell);
}

// Finds the position of a patch's hemicube and the visible share of the patch.
static void placePatch(const Model &model, int index, Patch &patch) {
    const Chart &c = model.charts[patch.chart];
    int wide = c.patchAcross(), high = c.patchDown(), firstI = index % c.patchesAcross * wide,
        firstJ = index / c.patchesAcross * high;
    auto forPoints = [&](auto &&visit) {
        for (int j = firstJ; j < firstJ + high; ++j)
            for (int i = firstI; i < firstI + wide; ++i)
                for (int k = 0; k < 4; ++k)
                    if (model.quarterVisible(model.cells[c.firstCell + j * c.across + i], k))
                        visit(c.at(((float)i + (k & 1 ? 0.75f : 0.25f)) * c.width / (float)c.across,
                                   ((float)j + (k & 2 ? 0.75f : 0.25f)) * c.height / (float)c.down));
    };
    int count = 0;
    Vec3 sum = {};
    forPoints([&](Vec3 p) { sum += p, ++count; });
    int all = 4 * wide * high;
    patch.share = (float)count / (float)all;
    if (count == 0) return;
    Vec3 centroid = sum * (1.f / (float)count);
    patch.p = centroid;
    if (count == all) return;
    float least = kInfinity;
    forPoints([&](Vec3 p) {
        float distance = length(p - centroid);
        if (distance >= least * 0.999f) return; // keep the first of equals, despite rounding
        least = distance;
        patch.p = p;
    });
}

bool Model::divide(Arena &arena, int block) {
    texelCount = cellCount = patchCount = 0;
    for (int i = 0; i < chartCount; ++i) {
        // Round to patches of about `block` cells, and to the same number of cells in each patch
        Chart &c = charts[i];
        auto divideSide = [&](int16_t &cells, int16_t &patches) {
            int blocks = max((cells + block / 2) / block, 1);
            patches = (int16_t)blocks;
            cells = (int16_t)(max((cells + blocks / 2) / blocks, 1) * blocks);
        };
        divideSide(c.across, c.patchesAcross);
        divideSide(c.down, c.patchesDown);
        c.firstTexel = texelCount;
        c.firstCell = cellCount;
        c.firstPatch = patchCount;
        texelCount += c.texels();
        cellCount += c.across * c.down;
        patchCount += c.patchesAcross * c.patchesDown;
    }
    patches = arena.allocate<Patch>((size_t)patchCount);
    texels = arena.allocate<Texel>((size_t)texelCount);
    cells = arena.allocate<Cell>((size_t)cellCount);
    ties = arena.allocate<Tie>((size_t)texelCount * 4); // up to 4 for a cell with hidden corners
    if (arena.full) return false;

    for (int index = 0; index < chartCount; ++index) {
        const Chart &c = charts[index];
        for (int j = 0; j <= c.down; ++j)
            for (int i = 0; i <= c.across; ++i) texels[c.texel(i, j)] = {index, i, j, 0, 0, false};
        float area = c.width * c.height / (float)(c.across * c.down);
        for (int j = 0; j < c.down; ++j)
            for (int i = 0; i < c.across; ++i) {
                int t = c.texel(i, j), below = t + c.across + 1;
                int patch = c.firstPatch + j * c.patchesDown / c.down * c.patchesAcross +
                            i * c.patchesAcross / c.across;
                cells[c.firstCell + j * c.across + i] = {{t, t + 1, below, below + 1}, patch, index, area};
            }
    }
    return true;
}

void Model::placePatches() {
    for (int i = 0; i < chartCount; ++i)
        for (int k = 0; k < charts[i].patchesAcross * charts[i].patchesDown; ++k) {
            Patch &p = patches[charts[i].firstPatch + k];
            p = {{}, charts[i].n, {}, 0, 0, i};
            placePatch(*this, k, p);
        }
    for (int i = 0; i < cellCount; ++i) {
        int quarters = 0;
        for (int k = 0; k < 4; ++k) quarters += quarterVisible(cells[i], k);
        patches[cells[i].patch].area += cells[i].area * 0.25f * (float)quarters;
    }
}

Shape Model::shapeOf(int facet) const {
    const Facet &f = facets[facet];
    const Chart &c = charts[f.chart];
    Shape s = {};
    s.kind = ShapeKind::Rect;
    s.centre = c.at((f.u[0] + f.u[2]) * 0.5f, (f.v[0] + f.v[2]) * 0.5f);
    s.half = {(f.u[2] - f.u[0]) * 0.5f, 0, (f.v[2] - f.v[0]) * 0.5f};
    s.frame = {c.u, c.n, c.v};
    s.material = (uint8_t)c.material;
    s.chart = f.chart;
    return s;
}

void Model::pose(Scene &scene) const {
    for (int i = 0; i < facetCount; ++i)
        if (!charts[facets[i].chart].open) scene.add(shapeOf(i));
}

} // namespace odraz

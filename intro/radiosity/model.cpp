#include "radiosity/model.h"

#include <initializer_list>

namespace odraz {

int Model::addRect(Vec3 corner, Vec3 u, Vec3 v, int material, float element, Kind kind) {
    if (chartCount == kMaxCharts) return chartCount - 1;
    Chart &c = charts[chartCount];
    c = {};
    c.corner = corner;
    c.width = length(u), c.height = length(v);
    // Divided, not multiplied: along an axis it is exactly 1, and neighbours' corners meet exactly
    auto unit = [](Vec3 a, float length) { return Vec3{a.x / length, a.y / length, a.z / length}; };
    c.u = unit(u, c.width), c.v = unit(v, c.height);
    c.n = cross(c.u, c.v);
    c.material = (uint8_t)material;
    c.open = kind == kOpen;
    auto elements = [&](float side) { return (int16_t)clamp(side / element + 0.5f, 2.f, 500.f); };
    c.across = elements(c.width), c.down = elements(c.height);
    ++chartCount;
    if (kind != kPieces) addFacet(chartCount - 1, 0, 0, c.width, c.height);
    return chartCount - 1;
}

void Model::addFacet(int chart, float u0, float v0, float u1, float v1) {
    if (facetCount < kMaxFacets && u1 > u0 && v1 > v0) facets[facetCount++] = {chart, u0, v0, u1, v1};
}

void Model::addBox(Vec3 lo, Vec3 hi, int material, float element, unsigned sides) {
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
        if (sides >> i & 1) addRect(all[i].corner, all[i].u, all[i].v, material, element);
}

// Whether the nearest thing that points see in a direction is the back of a facet: then they lie inside a
// solid.
static Int8 seesBack(const Model &model, Vec3x8 p, Vec3 d, float tiny) {
    Float8 front = broadcast(kInfinity), back = front;
    for (int i = 0; i < model.facetCount; ++i) {
        const Facet &f = model.facets[i];
        const Chart &c = model.charts[f.chart];
        float slope = dot(c.n, d);
        if (abs(slope) < 1e-6f) continue;
        Float8 t = (dot(c.corner, c.n) - dot(p, c.n)) * (1.f / slope);
        Float8 &nearest = slope > 0 ? back : front;
        Int8 hit = (t > tiny) & (t < nearest);
        if (!any(hit)) continue;
        Vec3x8 q = p + d * t - c.corner;
        Float8 u = dot(q, c.u), v = dot(q, c.v);
        hit &= (u >= f.u0) & (u <= f.u1) & (v >= f.v0) & (v <= f.v1);
        nearest = select(hit, t, nearest);
    }
    return (back <= front * 1.0001f) & (back < kInfinity);
}

// A place inside a solid that stands against a wall may look along it and see the wall: so in several
// directions; and from two sides, so that what touches a solid's edge counts as inside.
static Int8 insideSolid(const Model &model, const Chart &c, Vec3x8 p, Vec3 aside) {
    Vec3 lean = c.u * 0.83f + c.v * 0.61f;
    Int8 inside = {};
    for (float side : {1.f, -1.f})
        for (float slant : {1.f, 0.004f})
            inside |= seesBack(model, p + aside * side, normalize(c.n + lean * (side * slant)),
                               length(aside) * 0.001f);
    return inside;
}

static void findVisible(Model &model, int index) {
    const Chart &c = model.charts[index];
    float du = c.width / (float)c.across, dv = c.height / (float)c.down;
    for (int j = 0; j < c.down; ++j)
        for (int i0 = 0; i0 < c.across; i0 += 8)
            for (int place = 0; place < 4; ++place) {
                Float8 u = (toFloat(kLanes + i0) + placeU(place)) * du;
                float v = ((float)j + placeV(place)) * dv;
                Int8 there = {};
                for (int k = 0; k < model.facetCount; ++k) {
                    const Facet &f = model.facets[k];
                    if (f.chart == index && v >= f.v0 && v <= f.v1) there |= (u >= f.u0) & (u <= f.u1);
                }
                there &=
                    ~insideSolid(model, c, c.u * u + (c.corner + c.v * v), (c.u * du + c.v * dv) * 0.02f);
                for (int k = 0; k < min(8, c.across - i0); ++k)
                    model.visible[c.texel(i0 + k, j)] |= (uint8_t)((there[k] & 1) << place);
            }
}

// Where the hemicube of a patch stands, and how much of it is to be seen.
static void place(const Model &model, Patch &patch) {
    const Chart &c = model.charts[patch.chart];
    auto places = [&](auto &&visit) {
        for (int j = patch.j; j < patch.j + c.patchDown; ++j)
            for (int i = patch.i; i < patch.i + c.patchAcross; ++i)
                for (int k = 0; k < 4; ++k)
                    if (model.visible[c.texel(i, j)] >> k & 1)
                        visit(c.at(((float)i + placeU(k)) * c.width / (float)c.across,
                                   ((float)j + placeV(k)) * c.height / (float)c.down));
    };
    int count = 0;
    Vec3 sum = {};
    places([&](Vec3 p) { sum += p, ++count; });
    int all = 4 * c.patchAcross * c.patchDown;
    patch.share = (float)count / (float)all;
    if (count == 0) return;
    Vec3 middle = sum * (1.f / (float)count);
    patch.p = middle;
    if (count == all) return;
    float least = kInfinity;
    places([&](Vec3 p) {
        float distance = length(p - middle);
        if (distance >= least * 0.999f) return; // of equals the first, whatever their rounding
        least = distance;
        patch.p = p;
    });
}

bool Model::divide(Arena &arena, Workers &workers, int block) {
    texelCount = patchCount = 0;
    for (int i = 0; i < chartCount; ++i) {
        // Whole patches: the blocks nearest to what is asked, the elements as many as they hold
        Chart &c = charts[i];
        auto divideSide = [&](int16_t &elements, int8_t &patch) {
            int blocks = max((elements + block / 2) / block, 1);
            patch = (int8_t)max((elements + blocks / 2) / blocks, 1);
            elements = (int16_t)(patch * blocks);
        };
        divideSide(c.across, c.patchAcross);
        divideSide(c.down, c.patchDown);
        c.firstTexel = texelCount;
        c.firstPatch = patchCount;
        texelCount += c.texels();
        patchCount += c.patchesAcross() * c.patchesDown();
    }
    patches = arena.take<Patch>((size_t)patchCount);
    visible = arena.take<uint8_t>((size_t)texelCount);
    if (!patches || !visible) return false;
    parallelFor(workers, chartCount, [&](int i, int) {
        findVisible(*this, i);
        const Chart &c = charts[i];
        for (int k = 0; k < c.patchesAcross() * c.patchesDown(); ++k) {
            Patch &p = patches[c.firstPatch + k];
            p = {{},
                 0,
                 (uint16_t)i,
                 (int16_t)(k % c.patchesAcross() * c.patchAcross),
                 (int16_t)(k / c.patchesAcross() * c.patchDown)};
            place(*this, p);
        }
    });
    return true;
}

void Model::pose(Scene &scene) const {
    for (int i = 0; i < facetCount; ++i) {
        const Facet &f = facets[i];
        const Chart &c = charts[f.chart];
        if (c.open) continue;
        Shape s = {};
        s.kind = ShapeKind::Rect;
        s.material = c.material;
        s.centre = c.at((f.u0 + f.u1) * 0.5f, (f.v0 + f.v1) * 0.5f);
        s.half = {(f.u1 - f.u0) * 0.5f, 0, (f.v1 - f.v0) * 0.5f};
        s.frame = {c.u, c.n, c.v};
        s.chart = f.chart;
        scene.add(s);
    }
}

} // namespace odraz

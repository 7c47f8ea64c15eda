#include "transfer/room.h"

namespace odraz {

namespace {

// Stores the light of `followed` after each bounce.
bool followBounces(Room &room, const LightVector &followed, Arena &arena, Workers &workers) {
    const Radiosity &r = room.radiosity;
    const Model &m = room.model;
    size_t patches = (size_t)m.patchCount, columns = (size_t)r.system.columns;
    float *radiosity = arena.allocate<float>(patches * kSolveBlock),
          *indirect = arena.allocate<float>(patches * kSolveBlock);
    for (Rgb *&bounce : room.bounce) bounce = arena.allocate<Rgb>(patches);
    if (arena.full) return false;
    for (int b = 0; b <= kBounces; ++b) {
        if (b > 0) findIndirect(r.factors, m.patchCount, kSolveBlock, radiosity, indirect, workers);
        for (size_t i = 0; i < patches; ++i) {
            Rgb light = {};
            for (int k = 0; k < r.bases.count(); ++k)
                light += followed.bounced[k] * r.system.direct[i * columns + 3 * (size_t)k];
            const float *in = indirect + i * kSolveBlock;
            light += Rgb{in[0], in[1], in[2]};
            room.bounce[b][i] = light;
            Rgb out = light * room.mean[m.charts[m.patches[i].chart].material];
            float *to = radiosity + i * kSolveBlock;
            to[0] = out.x, to[1] = out.y, to[2] = out.z;
        }
    }
    return true;
}

// Finds the patch nearest to a point, and stores its hemicube.
bool visit(Room &room, const Vec3 &point, const Scene &scene, const SolverHost &host) {
    const Model &m = room.model;
    float least = kInfinity;
    for (int i = 0; i < m.patchCount; ++i) {
        float distance = length(m.patches[i].p - point);
        if (distance >= least) continue;
        least = distance;
        room.visited = i;
    }
    Hemicubes h;
    room.seen = host.arena.allocate<uint32_t>((size_t)((3 * kSeen + 1) * kSeen));
    if (host.arena.full || !host.method.open(h, host.gl, scene, host.arena, kSeen)) return false;
    Eye eye = {m.patches[room.visited].p, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    if (!host.method.fill(h, m, &eye, 1)) return false;
    for (int i = 0; i < 3 * kSeen * kSeen; ++i)
        room.seen[i] = hemicubeIds(h, 0)[i / kSeen * hemicubeStride(h) + i % kSeen];
    host.method.close(h);
    return true;
}

// Sets the lightmap's pointers to the room's planes and gloss.
bool fillLightmap(Room &room, Arena &arena) {
    const Model &m = room.model;
    for (int k = 0; k < 3; ++k) {
        room.light[k] = arena.allocate<float>((size_t)m.texelCount + 8);
        room.mosaic[k] = arena.allocate<float>((size_t)m.patchCount);
        room.map.plane[k] = room.light[k];
        room.map.patch[k] = room.mosaic[k];
        room.map.gloss[k] = room.gloss.plane[k];
    }
    room.map.glossy = room.gloss.chart;
    room.map.glossAcross = room.gloss.across;
    room.map.glossDown = room.gloss.down;
    if (!arena.full) room.map.charts = m.charts;
    return room.solved();
}

} // namespace

const char *solveRoom(Room &room, Scene &scene, const RoomSettings &s, const SolverHost &host) {
    auto &[method, gl, arena, workers, progress] = host;
    for (int i = 0; i < scene.materialCount; ++i) room.mean[i] = scene.mean[i];
    bool solved =
        solveRadiosity(room.radiosity, room.model, scene, s.radiosity, host) &&
        findGlossy(room.gloss, room.model, room.radiosity, s.polished, s.exponent, arena, workers) &&
        followBounces(room, s.followed, arena, workers) && visit(room, s.visited, scene, host) &&
        fillLightmap(room, arena);
    if (arena.full) return "not enough memory: try a smaller --size";
    if (!solved)
        return "cannot light the hall: OpenGL 3.3 cannot draw integers: "
               "try a newer driver or LIBGL_ALWAYS_SOFTWARE=1";
    method.close(room.radiosity.hemicubes);
    char *from = (char *)room.radiosity.factors.links; // solving allocates `matrices` later
    if (arena.giveBack) arena.giveBack(from, (size_t)((char *)room.gloss.matrices - from));
    return nullptr;
}

Rgb meanLight(const Room &room, int chart) {
    const Chart &c = room.model.charts[chart];
    float sum[3] = {};
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < c.texels(); ++i) sum[k] += room.light[k][c.firstTexel + i];
    float inverse = 1.f / (float)c.texels();
    return {sum[0] * inverse, sum[1] * inverse, sum[2] * inverse};
}

} // namespace odraz

#include "tools/radiosity/transfer/relight.h"

#include "tools/radiosity/read/upright.h"

#include <algorithm>

namespace odraz::radiosity {

BandLight turnedSky(const BandLight &sky, const TransferRoom &room, double turn, double tilt) {
    if (turn == 0 && tilt == 0) return sky;
    Vec3 up = asInModel({0, 1, 0}, room.upIsZ);
    return turned(sky, room.bands, turnAbout({1, 0, 0}, tilt) * turnAbout(up, -turn));
}

// The weight of each of the room's bases.
static LightVector lightVector(const TransferRoom &room, const Lighting &l) {
    LightVector v = {};
    int used = std::min(room.bands, l.bands);
    for (int k = 0; k < used * used; ++k) v.bounced[k] = l.sky[(size_t)k];
    for (size_t k = 0; k < room.lamps.size(); ++k) {
        float strength = k < l.lamps.size() ? l.lamps[k] : 1;
        v.bounced[(size_t)room.functions() + k] = {strength, strength, strength};
    }
    return v;
}

Relighter::Relighter(const TransferRoom &room) : room(room), model(std::make_unique<Model>()) {
    model->texelCount = (int)room.texels();
    radiosity.bases.skyCount = room.bases();
    for (int k = 0; k < room.bases(); ++k) {
        for (int c = 0; c < 3; ++c) radiosity.bounced[k][c] = const_cast<float *>(room.plane(k, c));
        radiosity.direct[k] = radiosity.bounced[k][0]; // its weight is 0
    }
    for (auto &plane : sums) plane.resize(room.stride());
}

void Relighter::relight(const Clusters &c, const Lighting &lighting, std::vector<Rgb> &light) {
    LightVector v = lightVector(room, lighting);
    light.resize(room.texels());
    if (lighting.rank < 0) {
        float *const planes[3] = {sums[0].data(), sums[1].data(), sums[2].data()};
        odraz::relight(radiosity, *model, v, planes);
        for (size_t t = 0; t < light.size(); ++t) light[t] = {planes[0][t], planes[1][t], planes[2][t]};
        return;
    }
    int rank = std::min(lighting.rank, c.rank), bases = room.bases();
    std::vector<Rgb> lit((size_t)c.count * (size_t)(1 + rank)); // the means and axes under this light
    for (int k = 0; k < c.count; ++k)
        for (int d = 0; d <= rank; ++d) {
            const float *axis = c.axesOf(k) + (size_t)d * (size_t)c.columns;
            Rgb sum = {};
            for (int i = 0; i < bases; ++i)
                sum += v.bounced[i] * Rgb{axis[3 * i], axis[3 * i + 1], axis[3 * i + 2]};
            lit[(size_t)(k * (1 + rank) + d)] = sum;
        }
    for (size_t t = 0; t < light.size(); ++t) {
        const Rgb *cluster = &lit[(size_t)(c.of[t] * (1 + rank))];
        const float *weights = c.weights.data() + t * (size_t)c.rank;
        Rgb sum = cluster[0];
        for (int d = 0; d < rank; ++d) sum += cluster[1 + d] * weights[d];
        light[t] = sum;
    }
}

void Relighter::show(const Clusters &clusters, const Lighting &lighting, const Vec3 *eye, Solution &to) {
    relight(clusters, lighting, to.light);
    for (Rgb &l : to.light) l = {std::max(l.x, 0.f), std::max(l.y, 0.f), std::max(l.z, 0.f)};
    LightVector v = lightVector(room, lighting);
    to.emits = room.model.emits;
    for (size_t c = 0; c < to.emits.size(); ++c)
        if (int lamp = room.lampOf[c]; lamp >= 0)
            to.emits[c] = to.emits[c] * v.bounced[room.functions() + lamp];
    if (eye) showGloss(room.gloss, to, v, *eye, room.polish);
}

Solution litModel(const TransferRoom &room, const Lighting &lighting, const Vec3 *eye) {
    Solution model = room.model;
    Relighter(room).show(room.clusters, lighting, eye, model);
    return model;
}

} // namespace odraz::radiosity

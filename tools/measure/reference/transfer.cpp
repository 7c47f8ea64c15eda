#include "tools/measure/reference/transfer.h"

#include <cmath>

namespace odraz::measure {

namespace {

// Solves the hall for the exact skies and suns of some days. Bases: red, green and blue of each sky, then the
// suns.
SolvedHall solvedFor(const std::vector<Sky> &skies, const std::vector<Daylight> &days, const Gl &gl,
                     Workers &workers) {
    return SolvedHall(kHallSettings, kDrawnHemicubes, gl, workers, kRoomBytes, [&](Hall &hall) {
        LightBases &l = hall.radiosity.bases;
        l.skyCount = 3 * (int)skies.size();
        l.skies = &skies;
        l.sky = [](const void *from, const Vec3x8 &d, Float8 *values) {
            for (const Sky &sky : *(const std::vector<Sky> *)from) {
                Rgb8 light = radiance(sky, d);
                *values++ = light.x, *values++ = light.y, *values++ = light.z;
            }
        };
        l.sunCount = (int)days.size();
        for (size_t i = 0; i < days.size(); ++i) l.suns[i] = days[i].sunAt;
        l.lampCount = 0;
    });
}

// The error of the relit planes against the exact planes of a day. The exact sky includes the glow near the
// sun. The picture draws that glow as part of the sun, whose direct light is `direct`.
DayError errorOf(const TexelPlanes &relit, const TexelPlanes &exact, const float *direct, int texels,
                 const Daylight &day) {
    Rgb glow = day.sky.near * kNearGlow, alone = day.sunlight - glow;
    double error = 0, base = 0, whole = 0, wholeBase = 0;
    for (size_t c = 0; c < 3; ++c) {
        auto channel = [&](Rgb v) { return (double)(c == 0 ? v.x : c == 1 ? v.y : v.z); };
        for (int t = 0; t < texels; ++t) {
            double sun = (double)direct[t], g = (double)relit.plane[c][t], e = (double)exact.plane[c][t];
            double withSun = g + sun * channel(day.sunlight), truth = e + sun * channel(alone);
            whole += (withSun - truth) * (withSun - truth), wholeBase += truth * truth;
            // Remove the glow, which the picture draws with the sun
            e -= sun * channel(glow);
            error += (g - e) * (g - e), base += e * e;
        }
    }
    return {0, 100 * std::sqrt(error / base), 100 * std::sqrt(whole / wholeBase)};
}

} // namespace

std::vector<DayError> dayErrors(const std::vector<float> &hours, const Gl &gl, Workers &workers) {
    SolvedHall relit(kHallSettings, kDrawnHemicubes, gl, workers);
    const Model &m = relit.hall->model;
    TexelPlanes relitPlanes(m.texelCount), exactPlanes(m.texelCount);
    std::vector<Sky> skies;
    std::vector<Daylight> days;
    for (float hour : hours) {
        days.push_back(daylightAt(hour));
        skies.push_back(days.back().sky);
    }
    SolvedHall exact = solvedFor(skies, days, gl, workers);
    std::vector<DayError> all;
    for (size_t i = 0; i < days.size(); ++i) {
        LightVector own = {};
        int sky = 3 * (int)i, sun = exact.hall->radiosity.bases.firstSun() + (int)i;
        own.bounced[sky] = {1, 0, 0}, own.bounced[sky + 1] = {0, 1, 0}, own.bounced[sky + 2] = {0, 0, 1};
        own.bounced[sun] = days[i].sunlight - days[i].sky.near * kNearGlow;
        relight(exact.hall->radiosity, exact.hall->model, own, exactPlanes.plane);
        relight(relit.hall->radiosity, m, lightVector({hours[i], {}, {}, 1}), relitPlanes.plane);
        all.push_back(
            errorOf(relitPlanes, exactPlanes, exact.hall->radiosity.direct[sun], m.texelCount, days[i]));
        all.back().hour = hours[i];
    }
    return all;
}

} // namespace odraz::measure

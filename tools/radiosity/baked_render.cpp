// A solved model as a picture, by the film's tracer.
#include "tools/radiosity/baked.h"

#include "base/maths.h"
#include "tools/common/heap_arena.h"
#include "tools/common/statistics.h"
#include "tools/picture/picture.h"
#include "tools/radiosity/regions.h"
#include "tools/radiosity/upright.h"
#include "trace/picture/development.h"
#include "trace/picture/tracer.h"

#include <algorithm>
#include <cmath>

namespace odraz {

void placeCamera(const Baked &baked, RenderSettings &s) {
    std::vector<Vec3> corners;
    for (const Facet &f : baked.facets)
        for (int k = 0; k < 4; ++k)
            corners.push_back(upright(f.corner(baked.charts[(size_t)f.chart], k), s.upIsZ));
    if (corners.empty()) return;
    Vec3 lo = corners[0], hi = lo;
    for (const Vec3 &p : corners)
        for (float Vec3::*k : {&Vec3::x, &Vec3::y, &Vec3::z})
            lo.*k = std::min(lo.*k, p.*k), hi.*k = std::max(hi.*k, p.*k);
    Vec3 middle = (lo + hi) * 0.5f, away = normalize(Vec3{0.5f, 0.55f, 0.8f});
    Vec3 right = normalize(cross(Vec3{0, 1, 0}, away)), up = cross(away, right);
    float tall = std::tan(s.lens * (kPi / 360)) * 0.95f, wide = tall * (float)s.width / (float)s.height,
          far = 0;
    for (const Vec3 &p : corners) {
        Vec3 c = p - middle;
        far = std::max(far, dot(c, away) +
                                std::max(std::fabs(dot(c, right)) / wide, std::fabs(dot(c, up)) / tall));
    }
    s.eye = asInModel(middle + away * far, s.upIsZ);
    s.target = asInModel(middle, s.upIsZ);
}

void render(const Baked &baked, const RenderSettings &s, Workers &workers, const std::string &path) {
    size_t bytes = ((size_t)s.width + 16) * (size_t)s.height * 32 +
                   (size_t)workers.count * kTileScratchBytes + ((size_t)1 << 20);
    HeapArena memory(bytes);
    Tracer tracer = {};
    Frame frame = {};
    if (!makeTracer(tracer, memory.arena, workers.count) ||
        !makeFrame(frame, memory.arena, s.width, s.height))
        throw std::runtime_error("there is not enough memory: try a smaller --size");

    // Every polygon shows its radiosity: a white surface in that light
    auto scene = std::make_unique<Scene>();
    auto model = std::make_unique<Model>();
    std::copy(baked.charts.begin(), baked.charts.end(), model->charts);
    for (size_t i = 0; i < baked.charts.size(); ++i)
        for (Vec3 Chart::*axis : {&Chart::corner, &Chart::u, &Chart::v, &Chart::n})
            model->charts[i].*axis = upright(baked.charts[i].*axis, s.upIsZ);
    std::copy(baked.facets.begin(), baked.facets.end(), model->facets);
    model->chartCount = (int)baked.charts.size(), model->facetCount = (int)baked.facets.size();
    std::vector<float> planes[3];
    for (auto &p : planes) p.resize(baked.texels.size() + 8);
    for (size_t i = 0; i < baked.texels.size(); ++i) {
        size_t chart = (size_t)baked.texels[i].chart;
        Rgb b = baked.light[i] * baked.reflects[chart] + baked.emits[chart];
        planes[0][i] = b.x, planes[1][i] = b.y, planes[2][i] = b.z;
    }
    Lightmap map = {};
    map.charts = model->charts;
    map.cells = baked.cells.data();
    for (int k = 0; k < 3; ++k) map.plane[k] = planes[k].data();
    Material white = {};
    for (Rgb &c : white.texture.palette) c = {1, 1, 1};
    white.diffuse = 1;
    scene->clear();
    scene->add(white);
    poseFacets(*model, *scene);
    scene->lightmap = &map;
    scene->finish();

    // Exposed for what the camera sees
    View view = lookAt(upright(s.eye, s.upIsZ), upright(s.target, s.upIsZ), 0, s.lens, s.width, s.height);
    auto trace = [&] {
        traceFrame(tracer, workers, *scene, view, kQualities[(int)QualityName::Film], frame);
        std::vector<float> all;
        for (int y = 0; y < s.height; ++y)
            for (int x = 0; x < s.width; ++x) {
                size_t at = (size_t)y * (size_t)frame.stride + (size_t)x;
                float light = std::max({frame.plane[0][at], frame.plane[1][at], frame.plane[2][at]});
                if (light > 0) all.push_back(light);
            }
        if (all.empty()) all.push_back(1); // all is black
        return all;
    };
    std::vector<float> all = trace();
    // Squares are judged by what is seen: once more with the exposure that was found
    scene->exposure = std::exp2(s.stops) * 0.5f / std::max(quantile(all, 0.6), 1e-30f);
    all = trace();
    Picture picture = {s.width, s.height, {}};
    picture.rgb.resize((size_t)s.width * (size_t)s.height * 3);
    float low = std::log(std::max(quantile(all, 0.01), 1e-30f)),
          high = std::log(std::max(quantile(all, 0.998), 1e-30f));
    if (!s.logarithmic) {
        Curve curve;
        makeCurve(curve);
        develop(curve, frame, workers, scene->exposure, 0);
    }
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            size_t at = (size_t)y * (size_t)frame.stride + (size_t)x,
                   pixel = (size_t)y * (size_t)s.width + (size_t)x;
            float c[3] = {frame.plane[0][at], frame.plane[1][at], frame.plane[2][at]};
            float light = std::max({c[0], c[1], c[2]});
            // The darkest is not black: it shall be seen too
            float rank = light > 0 ? (std::log(light) - low) / std::max(high - low, 1e-3f) : 0;
            float shown = 0.1f + 0.9f * std::clamp(rank, 0.f, 1.f);
            for (size_t k = 0; k < 3; ++k)
                picture.rgb[pixel * 3 + k] =
                    s.logarithmic
                        ? (uint8_t)(light > 0
                                        ? shown * std::pow(std::max(c[k], 0.f) / light, 1 / 2.2f) * 255 + 0.5f
                                        : 0)
                        : frame.rgba[pixel * 4 + k];
        }
    if (!writePng(path, picture)) throw std::runtime_error("cannot write " + path);
}

} // namespace odraz

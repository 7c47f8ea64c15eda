#include "tools/radiosity/export/render.h"

#include "base/maths.h"
#include "tools/common/statistics.h"
#include "tools/picture/picture.h"
#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/read/upright.h"
#include "trace/picture/development.h"
#include "trace/rays/view.h"
#include "trace/scene/bounds.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

// The horizontal direction to the only open side of a room: five sides of its box have polygons that face
// inwards. 0 if there is no such side. `lo` and `hi`: the box, with y up.
static Vec3 openSideOf(const Solution &solution, bool upIsZ, const Vec3 &lo, const Vec3 &hi) {
    const Vec3 size = hi - lo;
    Vec3 open = {};
    int closed = 0;
    for (const Vec3 &axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        for (const Vec3 &out : {axis, axis * -1.f}) {
            const float at = std::max(dot(lo, out), dot(hi, out));
            double area = 0, whole = (double)(size.x * size.y * size.z / dot(size, axis));
            for (const Facet &f : solution.facets) {
                const Chart &c = solution.charts[(size_t)f.chart];
                if (dot(upright(c.n, upIsZ), out) < -0.9f &&
                    at - dot(upright(f.corner(c, 0), upIsZ), out) < 0.02f * length(size))
                    area += areaOf(outlineOf(f));
            }
            closed += area > 0.5 * whole;
            if (axis.y == 0 && area < 0.1 * whole) open = out;
        }
    return closed == 5 ? open : Vec3{};
}

void placeCamera(const Solution &solution, RenderSettings &s) {
    s.origin = solution.origin;
    std::vector<Vec3> corners;
    for (const Facet &f : solution.facets)
        for (int k = 0; k < 4; ++k)
            corners.push_back(upright(f.corner(solution.charts[(size_t)f.chart], k), s.upIsZ));
    if (corners.empty()) return;
    Vec3 lo = corners[0], hi = lo;
    for (const Vec3 &p : corners) lo = lower(lo, p), hi = upper(hi, p);
    // Look from the first octant, or if hardly any front faces it, from the octant that most fronts face
    auto from = [&](int octant) {
        return normalize(
            Vec3{octant & 1 ? -0.5f : 0.5f, octant & 2 ? -0.55f : 0.55f, octant & 4 ? -0.8f : 0.8f});
    };
    double fronts[8] = {};
    int best = 0;
    for (int k = 0; k < 8; ++k) {
        for (const Facet &f : solution.facets) {
            const Chart &c = solution.charts[(size_t)f.chart];
            fronts[k] += areaOf(outlineOf(f)) * (double)std::max(dot(upright(c.n, s.upIsZ), from(k)), 0.f);
        }
        if (fronts[k] > fronts[best] * 1.001) best = k;
    }
    Vec3 middle = (lo + hi) * 0.5f, away = openSideOf(solution, s.upIsZ, lo, hi);
    if (length(away) == 0) away = from(fronts[0] < 0.1 * fronts[best] ? best : 0);
    Vec3 right = normalize(cross(Vec3{0, 1, 0}, away)), up = cross(away, right);
    // Find the distance at which the field of view, less 5 %, holds all corners
    float tanY = std::tan(s.lens * (kPi / 360)) * 0.95f, tanX = tanY * (float)s.width / (float)s.height,
          distance = 0;
    for (const Vec3 &p : corners) {
        Vec3 c = p - middle;
        distance = std::max(
            distance, dot(c, away) + std::max(std::fabs(dot(c, right)) / tanX, std::fabs(dot(c, up)) / tanY));
    }
    s.eye = asInModel(middle + away * distance, s.upIsZ);
    s.target = asInModel(middle, s.upIsZ);
}

namespace {

// A solution's radiosity as a camera sees it.
class RadiosityView {
public:
    RadiosityView(const Solution &solution, const RenderSettings &s)
        : solution(solution),
          view(lookAt(upright(s.eye, s.upIsZ), upright(s.target, s.upIsZ), 0, s.lens, s.width, s.height)),
          upIsZ(s.upIsZ), eye(s.eye), tree(cornersOf(solution.facets, solution.charts.data(), charts)) {}

    struct Hit {
        int chart; // -1: nothing
        Rgb light;
    };
    Hit at(float x, float y) const {
        Vec3 d = asInModel(view.direction(x, y), upIsZ);
        RayHit hit = tree.nearestFront(eye, d);
        if (hit.triangle < 0) return {-1, {}};
        int chart = charts[(size_t)hit.triangle];
        return {chart, solution.radiosityAt(chart, eye + d * hit.t)};
    }

private:
    const Solution &solution;
    View view;
    bool upIsZ;
    Vec3 eye;
    std::vector<int> charts; // each triangle's chart
    RayTree tree;
};

// Traces each pixel with one sample, and then pixels that differ from their neighbours with 4 x 4 samples.
void traceFrame(const RadiosityView &view, Workers &workers, Frame &frame) {
    std::vector<RadiosityView::Hit> first((size_t)frame.width * (size_t)frame.height);
    auto at = [&](int x, int y) -> RadiosityView::Hit & {
        return first[(size_t)y * (size_t)frame.width + (size_t)x];
    };
    parallelFor(workers, frame.height, [&](int y, int) {
        for (int x = 0; x < frame.width; ++x) at(x, y) = view.at((float)x + 0.5f, (float)y + 0.5f);
    });
    auto differs = [](const RadiosityView::Hit &a, const RadiosityView::Hit &b) {
        auto unlike = [](float x, float y) { return std::fabs(x - y) > 0.05f * std::max(x, y); };
        return a.chart != b.chart && (a.chart < 0 || b.chart < 0 || unlike(a.light.x, b.light.x) ||
                                      unlike(a.light.y, b.light.y) || unlike(a.light.z, b.light.z));
    };
    parallelFor(workers, frame.height, [&](int y, int) {
        for (int x = 0; x < frame.width; ++x) {
            RadiosityView::Hit &pixel = at(x, y);
            bool edge = false;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, frame.height - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, frame.width - 1); ++i)
                    edge |= differs(pixel, at(i, j));
            Rgb light = pixel.light;
            if (edge) {
                light = {};
                for (int k = 0; k < 16; ++k)
                    light += view.at((float)x + ((float)(k & 3) + 0.5f) / 4,
                                     (float)y + ((float)(k >> 2) + 0.5f) / 4)
                                 .light *
                             (1 / 16.f);
            }
            size_t to = (size_t)y * (size_t)frame.stride + (size_t)x;
            frame.plane[0][to] = light.x, frame.plane[1][to] = light.y, frame.plane[2][to] = light.z;
        }
    });
}

} // namespace

HeapFrame::HeapFrame(int width, int height) : memory(((size_t)width + 64) * (size_t)height * 32 + 65536) {
    if (!makeFrame(frame, memory.arena, width, height))
        throw std::runtime_error("there is not enough memory: try a smaller --size");
}

std::vector<Rgb> HeapFrame::pixels() const {
    std::vector<Rgb> all;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) all.push_back({at(0, x, y), at(1, x, y), at(2, x, y)});
    return all;
}

Rgb logarithmicTone(const Rgb &c, float low, float high) {
    float light = maxComponent(c);
    if (!(light > 0)) return {};
    // Make the darkest value brighter than black, so that it is visible
    float rank = (std::log(light) - low) / std::max(high - low, 1e-3f),
          bright = 0.1f + 0.9f * std::clamp(rank, 0.f, 1.f);
    auto channel = [&](float x) { return bright * std::pow(std::max(x, 0.f) / light, 1 / 2.2f); };
    return {channel(c.x), channel(c.y), channel(c.z)};
}

void render(const Solution &solution, const RenderSettings &s, Workers &workers, const std::string &path) {
    HeapFrame traced(s.width, s.height);
    traceFrame(RadiosityView(solution, s), workers, traced.frame);
    std::vector<Rgb> pixels = traced.pixels();
    if (pictures::formatNamed(path, pictures::Format::Exr) == pictures::Format::Exr) {
        std::vector<float> light;
        for (const Rgb &c : pixels) light.insert(light.end(), {c.x, c.y, c.z});
        return pictures::writeExr(path, s.width, s.height, light);
    }
    std::vector<float> all;
    for (const Rgb &c : pixels)
        if (float light = maxComponent(c); light > 0) all.push_back(light);
    if (all.empty()) all.push_back(1); // the picture is black
    auto part = [&](double share) { return std::max(common::quantile(all, share), 1e-30f); };
    float low = std::log(part(0.01)), high = std::log(part(0.998));
    bool film = !(s.constant > 0) && !s.logarithmic;
    if (film) { // the exposure adapts to the picture
        ToneCurve curve;
        makeToneCurve(curve);
        develop(curve, traced.frame, workers, std::exp2(s.stops) * 0.5f / part(0.6), 0);
    }
    pictures::Image picture = {s.width, s.height, std::vector<uint8_t>(pixels.size() * 3)};
    for (size_t i = 0; i < pixels.size(); ++i) {
        Rgb c = s.constant > 0 ? pixels[i] * s.constant : logarithmicTone(pixels[i], low, high);
        const float shown[3] = {c.x, c.y, c.z};
        for (size_t k = 0; k < 3; ++k)
            picture.rgb[i * 3 + k] =
                film ? traced.frame.rgba[i * 4 + k] : (uint8_t)(std::clamp(shown[k], 0.f, 1.f) * 255 + 0.5f);
    }
    pictures::writePng(path, picture);
}

} // namespace odraz::radiosity

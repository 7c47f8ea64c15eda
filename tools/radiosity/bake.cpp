#include "tools/radiosity/bake.h"

#include "tools/radiosity/regions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <sys/mman.h>

namespace odraz {

const char *const Bake::kSteps[5] = {"dividing", "form factors", "direct light", "solving", "final rays"};

void Bake::Free::operator()(void *memory) const { munmap(memory, *(size_t *)memory); }

Rgb Bake::reflects(int chart) const {
    if (!pictured.ofChart.empty()) return pictured.ofChart[(size_t)chart];
    const auto &r = materials[(size_t)material[(size_t)chart]].reflects;
    return {r[0], r[1], r[2]};
}
Rgb Bake::reflectsOf(int cell) const {
    if (!pictured.ofCell.empty()) return pictured.ofCell[(size_t)cell];
    return reflects(byRays ? cells[(size_t)cell].chart : model->cells[cell].chart);
}
Rgb Bake::emits(int chart) const {
    const auto &e = materials[(size_t)material[(size_t)chart]].emits;
    return {e[0], e[1], e[2]};
}

float SolvedShare::operator()(float left, float asked) {
    double now = std::log(std::max((double)left, 1e-12)), end = std::log((double)asked);
    if (begin == 0) begin = now;
    return (float)std::clamp(begin <= end ? 1 : (begin - now) / (begin - end), 0., 1.);
}

double cellOf(const Mesh &mesh, const BakeSettings &s) {
    // Final rays are for quality, which small elements are, too
    double element = s.element > 0 ? s.element : areaOf(mesh) / (s.final > 0 ? 120000 : 30000);
    return std::sqrt(element) * (s.adaptive && s.way == Way::kPatches ? 1 << kDivided : 1);
}

void refuseKept() {
    throw std::runtime_error("what was kept of it is damaged, or of another model: solve it anew");
}

namespace {

void join(Bake &b, const Mesh &mesh) {
    double cell = cellOf(mesh, b.settings);
    b.regions = joinRegions(mesh, cell);
    b.material = b.regions.material;
    int coarse = 0;
    for (Chart &c : b.regions.charts) {
        coarse += (double)std::max(c.width, c.height) > (kMaxAcross + 1) * cell;
        // What is about as large as an element is one
        if ((double)(c.width * c.height) < 3 * cell * cell) c.across = c.down = 1;
    }
    if (coarse > 0)
        b.notes.push_back(std::to_string(coarse) + " polygons are longer than " + std::to_string(kMaxAcross) +
                          " elements: theirs are longer than asked");
}

// With an even sky where nothing shines.
void lightUp(Bake &b, const Mesh &mesh) {
    if (shines(mesh) || b.settings.surroundings.shine()) return;
    b.settings.surroundings.sky = evenSky({1, 1, 1});
    b.notes.push_back("nothing shines in it: lit by an even sky (--sky, --sun and --lamp give other light)");
}

// How far from the origin, where floats are finest, a model lies; nothing, where that is near enough.
Vec3d away(const Mesh &mesh) {
    Vec3d middle = mesh.middle();
    return length(middle) < 4 * mesh.size() ? Vec3d{} : middle;
}
Mesh moveHome(const Mesh &mesh, const Vec3d &from, Surroundings &around) {
    Mesh moved = mesh;
    for (Vec3d &p : moved.points) p = p - from;
    for (BallLamp &lamp : around.lamps) lamp.centre = lamp.centre - toFloat(from);
    return moved;
}

} // namespace

std::unique_ptr<Bake> bake(const Mesh &given, const BakeSettings &settings, const Gl &gl, Workers &workers,
                           const int *stop, const Told &told) {
    auto b = std::make_unique<Bake>();
    b->settings = settings;
    Vec3d moved = away(given);
    Mesh home;
    if (length(moved) > 0) home = moveHome(given, moved, b->settings.surroundings);
    const Mesh &mesh = length(moved) > 0 ? home : given;
    if (mesh.size() < length(moved) * 1e-5)
        b->notes.push_back("it lies so far from the origin that its coordinates are coarse: move it there");
    b->materials = mesh.materials;
    join(*b, mesh);
    lightUp(*b, mesh);
    b->byRays = settings.way == Way::kRays;
    if (b->byRays)
        bakeByRays(*b, mesh, workers, stop, told);
    else
        bakeByPatches(*b, mesh, gl, workers, stop, told);
    Chart *charts = b->byRays ? b->regions.charts.data() : b->model->charts;
    for (size_t i = 0; i < b->regions.charts.size(); ++i) charts[i].corner += toFloat(moved);
    return b;
}

} // namespace odraz

// bench_effects: compares the film's effects on balls with path tracing, in whole pictures.
#include "tools/common/clock.h"
#include "tools/common/command_line.h"
#include "tools/common/statistics.h"
#include "tools/common/whole_file.h"
#include "tools/engine/heap_arena.h"
#include "tools/engine/machine.h"
#include "tools/measure/oracle/effect_scenes.h"
#include "tools/measure/oracle/reference_picture.h"
#include "tools/picture/flip.h"
#include "tools/picture/psnr.h"
#include "trace/picture/development.h"
#include "trace/picture/tracer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace odraz::measure {

namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr double kBrightest = 4; // times the floor's light; brighter pixels count as this

struct Effort {
    int samples, photons; // as in PathSettings, for each half of a reference
};
constexpr Effort kWhole = {64, 2000}, kQuick = {8, 250};

using Radiances = std::vector<Vec3d>;

// The film's tracer on one of the small scenes.
struct Film {
    Workers workers = allProcessors();
    HeapArena memory{kTileScratchBytes * (size_t)workers.count + (64u << 20)};
    std::unique_ptr<Scene> scene = std::make_unique<Scene>();
    Tracer tracer;
    Frame frame = {};

    Film() {
        if (!makeTracer(tracer, memory.arena, workers.count) ||
            !makeFrame(frame, memory.arena, kWidth, kHeight))
            throw std::runtime_error("memory is short");
    }
    View pose(const EffectScene &effect, float bounced) {
        scene->clear();
        effect.pose(*scene, bounced);
        scene->finish();
        return lookAt(effect.eye, effect.target, 0, effect.fov, kWidth, kHeight);
    }
    Radiances trace(const View &view) {
        Quality q = kQualities[(int)QualityName::Reference];
        q.grid = 8;
        q.cutoff = 1 / 4096.f;
        traceFrame(tracer, workers, *scene, view, q, frame);
        Radiances picture((size_t)kWidth * kHeight);
        for (size_t i = 0; i < picture.size(); ++i) {
            size_t at = i / kWidth * (size_t)frame.stride + i % kWidth;
            picture[i] = {(double)frame.plane[0][at], (double)frame.plane[1][at], (double)frame.plane[2][at]};
        }
        return picture;
    }
};

std::vector<uint8_t> shown(const Radiances &picture) {
    std::vector<uint8_t> bytes;
    for (const Vec3d &p : picture)
        for (size_t c = 0; c < 3; ++c)
            bytes.push_back((uint8_t)(encodeSrgb(clamp(broadcast((float)p[c]), 0.f, 1.f))[0] * 255 + 0.5f));
    return bytes;
}

void write(const std::string &path, const Radiances &picture) {
    std::vector<uint8_t> bytes = shown(picture);
    common::writeWhole(path, "P6\n" + std::to_string(kWidth) + " " + std::to_string(kHeight) + "\n255\n" +
                                 std::string(bytes.begin(), bytes.end()));
}

// How much a picture with the effect and one without it differ from the truth, as shares of the floor's
// light. The truth has two halves with independent noise: the product of the differences from each half is
// free of noise in the mean.
struct Differences {
    double without, withoutMean, with, withMean; // root mean squares, and mean brightness
    double strength; // of the effect in the picture: the factor of the true effect that fits best
    double worst;    // 99 of 100 pixels stay below this in their largest channel, noise included
    double noise;    // root mean square, of both halves together

    Differences(const Radiances &bare, const Radiances &film, const Radiances (&truth)[2]) {
        double sums[7] = {};
        std::vector<double> most(film.size());
        for (size_t i = 0; i < film.size(); ++i)
            for (size_t c = 0; c < 3; ++c) {
                double n = counted(bare[i][c]), f = counted(film[i][c]), a = counted(truth[0][i][c]),
                       b = counted(truth[1][i][c]), t = (a + b) / 2;
                const double terms[] = {(n - a) * (n - b),    n - t,
                                        (f - a) * (f - b),    f - t,
                                        (f - n) * (t - n),    (a - n) * (b - n),
                                        (a - b) * (a - b) / 4};
                for (size_t k = 0; k < 7; ++k) sums[k] += terms[k] / (3. * kWidth * kHeight);
                most[i] = std::max(most[i], std::fabs(f - t));
            }
        without = root(sums[0]), withoutMean = sums[1], with = root(sums[2]), withMean = sums[3];
        strength = sums[4] / sums[5], noise = root(sums[6]), worst = common::quantile(most, 0.99);
    }
    static double counted(double v) { return std::min(v / (double)kEffectShown, kBrightest); }
    static double root(double square) { return std::sqrt(std::max(square, 0.)); }
};

void measure(Film &film, const EffectScene &effect, bool bounces, const Effort &effort,
             const std::string &keep) {
    View view = film.pose(effect, bounces);
    Radiances with = film.trace(view);
    effect.strip(*film.scene);
    Radiances without = film.trace(view);
    film.pose(effect, bounces);
    effect.makeTrue(*film.scene);
    Radiances half[2], reference;
    for (uint32_t k = 0; k < 2; ++k)
        half[k] =
            tracePaths(*film.scene, view, {bounces, effort.samples, effort.photons, k + 1}, film.workers);
    for (size_t i = 0; i < half[0].size(); ++i) reference.push_back((half[0][i] + half[1][i]) * 0.5);

    Differences d(without, with, half);
    std::vector<uint8_t> seen = shown(with), truth = shown(reference);
    pictures::SeenPicture eye = pictures::see(truth, kWidth, kHeight);
    std::printf("%s,%s,%.2f,%.2f,", effect.name, bounces ? "all bounces" : "direct", d.without * 100,
                -d.withoutMean * 100);
    if (&effect != &effectScenes()[0]) std::printf("%.2f", d.strength); // the first scene has no effect
    std::printf(",%.2f,%.2f,%.2f,%.2f,%.1f,%.4f,%.4f\n", d.with * 100, d.withMean * 100, d.worst * 100,
                d.noise * 100, pictures::linearPsnr(seen, truth),
                pictures::meanFlip(eye, pictures::see(shown(without), kWidth, kHeight)),
                pictures::meanFlip(eye, pictures::see(seen, kWidth, kHeight)));
    std::fflush(stdout);
    if (keep.empty()) return;
    std::string name = keep + "/" + effect.name + (bounces ? ", all bounces" : "");
    write(name + ", without.ppm", without);
    write(name + ", film.ppm", with);
    write(name + ", paths.ppm", reference);
}

int run(common::CommandLine &line) {
    std::vector<std::string> only;
    std::string keep, known;
    bool quick = false;
    line.about("Draws small scenes by the film's tracer, 64 samples a pixel, and by path tracing. Prints a "
               "CSV with the\n"
               "differences of the pictures.");
    line.option("--only", "SCENE", only, "draw this scene");
    line.flag("--quick", quick, "trace fewer paths");
    line.option("--keep", "FOLDER", keep,
                "write the pictures, as PPM: without the effect, by the film, by paths");
    line.parse();
    const Effort effort = quick ? kQuick : kWhole;
    for (const EffectScene &e : effectScenes()) known += std::string(known.empty() ? "" : ", ") + e.name;
    for (const std::string &name : only)
        if (std::none_of(effectScenes().begin(), effectScenes().end(),
                         [&](auto &e) { return e.name == name; }))
            throw common::Refused("there is no scene '" + name + "'; there are: " + known);
    if (!keep.empty()) std::filesystem::create_directories(keep);
    Film film;
    std::puts("scene,against,effect,effect_mean,strength,rms,mean,p99,noise,linear_db,flip_without,flip");
    for (const EffectScene &effect : effectScenes()) {
        if (!only.empty() && std::find(only.begin(), only.end(), effect.name) == only.end()) continue;
        measure(film, effect, false, effort, keep);
        if (effect.bounces) measure(film, effect, true, effort, keep);
    }
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) {
    return common::runProgram("bench_effects", argc, argv, odraz::measure::run);
}

// bench_effects: how far the film's effects on balls are from what paths find, in whole pictures.
#include "tools/common/arguments.h"
#include "tools/common/clock.h"
#include "tools/common/heap_arena.h"
#include "tools/common/machine.h"
#include "tools/common/statistics.h"
#include "tools/common/whole_file.h"
#include "tools/measure/effect_scenes.h"
#include "tools/measure/flip.h"
#include "tools/measure/reference_picture.h"
#include "trace/picture/development.h"
#include "trace/picture/tracer.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: bench_effects [--only SCENE]... [--samples N=64] [--photons THOUSANDS=2000] [--quick] [--keep "
    "DIR]\n"
    "Draws small scenes with the film's tracer, 64 samples a pixel, and by paths, and writes a CSV of how "
    "far "
    "they are\n"
    "apart to stdout. --samples: of each of the two halves of a reference, a pixel. --keep writes PPM: the "
    "film's picture\n"
    "without the effect, as it is, and its references.\n";

namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr double kBrightest = 4; // times the floor's light: what is brighter counts as much

struct Wishes {
    std::vector<std::string> only;
    int samples = 64, photons = 2000;
    std::string keep;
};

using Radiances = std::vector<Vec3d>;

// The film's tracer, with a scene of its own.
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

void write(const Wishes &wishes, const std::string &name, const Radiances &picture) {
    if (wishes.keep.empty()) return;
    std::vector<uint8_t> bytes = shown(picture);
    writeWhole(wishes.keep + "/" + name + ".ppm", "P6\n" + std::to_string(kWidth) + " " +
                                                      std::to_string(kHeight) + "\n255\n" +
                                                      std::string(bytes.begin(), bytes.end()));
}

// How a picture differs from the truth, as shares of the floor's light. Of the truth there are two, whose
// noise differs: it does not count as an error.
struct Apart {
    double mean = 0, rms = 0;
    std::vector<double> pixels; // of each the largest of its colours, noise and all

    Apart(const Radiances &picture, const Radiances (&truth)[2]) {
        double squares = 0;
        for (size_t i = 0; i < picture.size(); ++i) {
            double most = 0;
            for (size_t c = 0; c < 3; ++c) {
                double is = counted(picture[i][c]), a = is - counted(truth[0][i][c]),
                       b = is - counted(truth[1][i][c]);
                mean += (a + b) / 2, squares += a * b;
                most = std::max(most, std::fabs(a + b) / 2);
            }
            pixels.push_back(most);
        }
        mean /= 3 * (double)picture.size();
        rms = std::sqrt(std::max(squares, 0.) / (3 * (double)picture.size()));
    }
    static double counted(double v) { return std::min(v / (double)kEffectShown, kBrightest); }
};
double noiseOf(const Radiances (&truth)[2]) { // of both together
    double squares = 0;
    for (size_t i = 0; i < truth[0].size(); ++i)
        for (size_t c = 0; c < 3; ++c)
            squares += std::pow((Apart::counted(truth[0][i][c]) - Apart::counted(truth[1][i][c])) / 2, 2);
    return std::sqrt(squares / (3 * (double)truth[0].size()));
}

// How strong an effect is by how strong it should be: the factor that fits best.
double strength(const Radiances &with, const Radiances &without, const Radiances (&truth)[2]) {
    auto counted = Apart::counted;
    double both = 0, own = 0;
    for (size_t i = 0; i < with.size(); ++i)
        for (size_t c = 0; c < 3; ++c) {
            double bare = counted(without[i][c]), a = counted(truth[0][i][c]) - bare,
                   b = counted(truth[1][i][c]) - bare;
            both += (counted(with[i][c]) - bare) * (a + b) / 2, own += a * b;
        }
    return both / own;
}

void measure(Film &film, const EffectScene &effect, bool bounces, const Wishes &wishes) {
    View view = film.pose(effect, bounces);
    Radiances with = film.trace(view);
    effect.strip(*film.scene);
    Radiances without = film.trace(view);
    film.pose(effect, bounces);
    if (effect.truth) effect.truth(*film.scene);
    Radiances half[2], reference;
    for (uint32_t k = 0; k < 2; ++k)
        half[k] =
            tracePaths(*film.scene, view, {bounces, wishes.samples, wishes.photons, k + 1}, film.workers);
    for (size_t i = 0; i < half[0].size(); ++i) reference.push_back((half[0][i] + half[1][i]) * 0.5);

    Apart apart(with, half), effects(without, half);
    std::vector<uint8_t> seen = shown(with), bare = shown(without), truth = shown(reference);
    SeenPicture eye = see(truth, kWidth, kHeight);
    const char *against = bounces ? "all bounces" : "direct";
    std::printf("%s,%s,%.2f,%.2f,", effect.name.c_str(), against, effects.rms * 100, -effects.mean * 100);
    if (&effect != &effectScenes()[0]) std::printf("%.2f", strength(with, without, half));
    std::printf(",%.2f,%.2f,%.2f,%.2f,%.1f,%.4f,%.4f\n", apart.rms * 100, apart.mean * 100,
                quantile(apart.pixels, 0.99) * 100, noiseOf(half) * 100, linearPsnr(seen, truth),
                meanFlip(eye, see(bare, kWidth, kHeight)), meanFlip(eye, see(seen, kWidth, kHeight)));
    std::fflush(stdout);
    std::string name = effect.name + (bounces ? ", all bounces" : "");
    write(wishes, name + ", without", without);
    write(wishes, name + ", film", with);
    write(wishes, name + ", paths", reference);
}

int run(Arguments &words) {
    Wishes wishes;
    std::string known;
    for (const EffectScene &e : effectScenes()) known += (known.empty() ? " " : ", ") + e.name;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--only") {
            wishes.only.push_back(words.value(w));
            bool is = false;
            for (const EffectScene &e : effectScenes()) is |= e.name == wishes.only.back();
            if (!is) throw Refused("there is no scene '" + wishes.only.back() + "'; there are:" + known);
        } else if (w == "--samples")
            wishes.samples = words.whole(w, 1, 1000000);
        else if (w == "--photons")
            wishes.photons = words.whole(w, 1, 1000000);
        else if (w == "--quick")
            wishes.samples = 8, wishes.photons = 250;
        else if (w == "--keep")
            wishes.keep = words.value(w);
        else
            words.refuse(w);
    }
    if (!wishes.keep.empty()) std::filesystem::create_directories(wishes.keep);
    Film film;
    std::puts("scene,against,effect rms %,effect mean %,strength,rms %,mean %,p99 %,noise %,linear dB,FLIP "
              "without,FLIP");
    for (const EffectScene &effect : effectScenes()) {
        if (!wishes.only.empty() &&
            std::find(wishes.only.begin(), wishes.only.end(), effect.name) == wishes.only.end())
            continue;
        measure(film, effect, false, wishes);
        if (effect.bounces) measure(film, effect, true, wishes);
    }
    return 0;
}

} // namespace

int main(int argc, char **argv) { return runProgram("bench_effects", kUsage, argc, argv, run); }

// listen: measures the film's music: levels, spectrum, onsets, hits.
#include "show/show.h"
#include "tools/common/command_line.h"
#include "tools/support/hits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odraz::measure {

static void printAll(const Recording &r) {
    double dc = 0, last[2] = {};
    float peak = 0;
    int clipped = 0;
    for (const std::vector<float> &side : r.side) {
        double sum = 0;
        for (float x : side) {
            sum += (double)x;
            peak = std::max(peak, std::fabs(x));
            clipped += std::fabs(x) >= 32767.f / 32768;
        }
        dc = std::max(dc, std::fabs(sum) / (double)side.size());
        size_t from = side.size() - std::min(side.size(), (size_t)r.rate / 10);
        for (size_t i = from; i < side.size(); ++i)
            last[0] += (double)side[i] * (double)side[i], last[1] += 1;
    }
    std::printf("all,%.2g,%d,%.4f,%.1f\n", dc, clipped, (double)peak,
                10 * std::log10(last[0] / last[1] + 1e-20));
}

// Finds clicks: the second difference at a click is much larger than around it.
static void printLargestStep(const Recording &r) {
    double worst = 0;
    for (const std::vector<float> &side : r.side)
        for (size_t i = 12; i + 12 < side.size(); ++i) {
            auto bend = [&](size_t i) {
                return std::fabs((double)side[i - 1] - 2 * (double)side[i] + (double)side[i + 1]);
            };
            double usual = 1e-3;
            for (size_t j = i - 10; j <= i + 10; ++j)
                if (j + 2 < i || j > i + 2) usual = std::max(usual, bend(j));
            worst = std::max(worst, bend(i) / usual);
        }
    std::printf("step,%.2f\n", worst);
}

static void printScene(const Recording &r, const char *name, size_t from, size_t to) {
    double ll = 1e-20, rr = 1e-20, lr = 0;
    for (size_t i = from; i < to && i < r.size(); ++i) {
        double a = (double)r.side[0][i], b = (double)r.side[1][i];
        ll += a * a, rr += b * b, lr += a * b;
    }
    std::printf("scene,%s,%.1f,%.2f,%.3f", name, 10 * std::log10((ll + rr) / 2 / (double)(to - from)),
                lr / std::sqrt(ll * rr), flatness(r, (int64_t)from, (int64_t)to));
    constexpr int kSize = 8192;
    double octave[10] = {}, sum = 1e-20;
    for (size_t at = from; at + kSize <= to; at += kSize / 2) {
        std::vector<double> e = spectrum(r, (int64_t)at, kSize);
        for (size_t i = 1; i < e.size(); ++i) {
            int o = (int)std::floor(std::log2((double)i * r.rate / kSize / 31.25));
            octave[std::clamp(o, 0, 9)] += e[i];
            sum += e[i];
        }
    }
    for (double o : octave) std::printf(",%.3f", o / sum);
    std::printf("\n");
}

static void printOnset(const Recording &r, const char *name, double row) {
    int64_t at = (int64_t)(row / kRowsPerSecond * r.rate);
    constexpr int kStep = 96;  // samples: 2 ms
    constexpr int kReach = 31; // steps on either side of the row
    double best = -1, off = 0;
    std::vector<double> around;
    for (int i = -125; i <= 125; ++i) {
        double f = flux(r, at + i * kStep, 480);
        around.push_back(f);
        if (std::abs(i) <= kReach && f > best) best = f, off = i * 2;
    }
    std::nth_element(around.begin(), around.begin() + 125, around.end());
    std::printf("onset,%s,%g,%g,%.1f\n", name, row, off, best / (around[125] + 0.5));
}

static int run(common::CommandLine &line) {
    std::string path;
    line.about("Measures the film's music, as odraz --wav writes it from the film's start. Prints these CSV "
               "rows:");
    line.notes(
        "all,DC,CLIPPED,PEAK,LAST     largest mean of a side; samples at full scale; largest sample; dB of\n"
        "                             the last 0.1 s\n"
        "step,LARGEST                 the largest jump between samples, relative to the 20 samples around "
        "it\n"
        "scene,NAME,RMS,CORRELATION,FLATNESS,OCTAVE...\n"
        "                             dB; correlation of left and right; spectral flatness from 2 to 12 "
        "kHz,\n"
        "                             0 for tones; shares of the octaves from 31.25 Hz on\n"
        "onset,NAME,ROW,OFF,STRENGTH  ms from a cut or an event to the strongest onset within 62 ms; the\n"
        "                             ratio of that onset to the median around it\n"
        "hit,ROW,RISE,BEFORE          a drum: ms until nine tenths of its amplitude; dB of the 0.2 s before");
    line.argument("FILE.wav", path, "the file that odraz --wav wrote");
    line.parse();
    Recording r = readWav(path);
    printAll(r);
    printLargestStep(r);
    auto sample = [&](double row) { return (size_t)(row / kRowsPerSecond * r.rate); };
    for (const SceneSpan &span : sceneSpans())
        printScene(r, kScenes[span.scene].name, sample(span.from), sample(span.to));
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &s = kFilm.shots[i];
        if (i) printOnset(r, "cut", (double)s.row);
        if (s.row == s.storyRow)
            for (const Event &e : kEvents)
                if (e.heard && e.scene == s.scene && s.row + e.row > 0)
                    printOnset(r, ("event" + std::to_string(e.id)).c_str(), (double)(s.row + e.row));
    }
    for (int row : hitRows()) {
        int64_t at = (int64_t)sample(row);
        std::printf("hit,%d,%.1f,%.1f\n", row, riseTime(r, at), level(r, at - r.rate / 5, at));
    }
    return 0;
}

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("listen", argc, argv, odraz::measure::run); }

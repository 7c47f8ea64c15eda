#include "tools/support/hits.h"

#include "show/score.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace odraz::measure {

std::vector<SceneSpan> sceneSpans() {
    std::vector<SceneSpan> spans;
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &s = kFilm.shots[i];
        double end = (double)(i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow);
        if (spans.empty() || spans.back().scene != s.scene) spans.push_back({s.scene, (double)s.row, end});
        spans.back().to = end;
    }
    return spans;
}

std::vector<int> hitRows() {
    std::vector<int> rows;
    auto m = std::make_unique<Mixer>();
    for (int row = 0; row < (int)kFilm.endRow; ++row) {
        m->voiceCount = 0;
        playRow(*m, row);
        for (int i = 0; i < m->voiceCount; ++i)
            if (m->voices[i].note.instrument == &kInstruments[kDrum]) {
                rows.push_back(row);
                break;
            }
    }
    return rows;
}

// The sum of squares over both sides.
static double energy(const Recording &r, int64_t from, int64_t to) {
    double sum = 0;
    for (int64_t i = std::max<int64_t>(from, 0); i < std::min(to, (int64_t)r.size()); ++i)
        for (const std::vector<float> &side : r.side)
            sum += (double)side[(size_t)i] * (double)side[(size_t)i];
    return sum;
}

double riseTime(const Recording &r, int64_t at) {
    const int window = r.rate / 500, step = window / 4, count = r.rate / 10 / step;
    std::vector<double> energies;
    for (int i = 0; i < count; ++i) energies.push_back(energy(r, at + i * step, at + i * step + window));
    double most = *std::max_element(energies.begin(), energies.end());
    for (int i = 0; i < count; ++i)
        if (energies[(size_t)i] >= 0.81 * most) return (double)(i * step + window) * 1000 / r.rate;
    return 1e3;
}

double level(const Recording &r, int64_t from, int64_t to) {
    return 10 * std::log10(energy(r, from, to) / 2 / (double)(to - from) + 1e-20);
}

double flatness(const Recording &r, int64_t from, int64_t to) {
    constexpr int kSize = 4096;
    size_t low = 2000 * kSize / (size_t)r.rate, high = 12000 * kSize / (size_t)r.rate;
    double sum = 0;
    int count = 0;
    for (int64_t at = from; at + kSize <= to; at += kSize / 2, ++count) {
        std::vector<double> e = spectrum(r, at, kSize);
        double logs = 0, all = 0;
        for (size_t i = low; i < high; ++i) logs += std::log(e[i] + 1e-15), all += e[i] + 1e-15;
        sum += std::exp(logs / (double)(high - low)) / all * (double)(high - low);
    }
    return sum / count;
}

} // namespace odraz::measure

#include "play/statistics.h"

#include "base/text.h"
#include "output/output.h"

namespace odraz {

// Pictures a second on an ideal screen: a sixtieth of a second without a new picture counts as missed.
static constexpr int kScreenRate = 60;

double Histogram::quantile(double share) const {
    int wanted = (int)(share * (double)count), seen = 0;
    for (int i = 0; i < kBins; ++i)
        if ((seen += bins[i]) > wanted) return i * 0.1;
    return 0;
}

void Statistics::add(const FinishedPicture &m, double at, int64_t present) {
    SceneStatistics &s = scenes[sceneAt(m.time)];
    if (present >= 0) {
        int64_t before = sixtieth;
        sixtieth = (int64_t)(at * kScreenRate) + 1;
        if (before && sixtieth > before + 1) s.missed += (int)(sixtieth - before - 1);
        ++s.shown;
        s.present.add(present);
    }
    if (m.trace > 0) {
        ++s.traced;
        s.samples += m.samples;
        s.width += m.size.width;
        s.trace.add((int64_t)(m.trace * 1e9f));
    } else {
        ++s.between;
        s.make.add((int64_t)(m.make * 1e9f));
    }
}

int printStatistics(const Statistics &statistics, const FilmClock &clock, double untilFirst) {
    Text<2048> t;
    (t << "first picture after ").decimal(untilFirst, 2) << " s\n";
    t << "                                            trace ms        between ms      present ms\n"
         "scene      traced  between  shown  missed  median p95      median p95      median p95      "
         "samples/pixel  width\n";
    for (int i = 0; i < kMaxScenes; ++i) {
        const SceneStatistics &s = statistics.scenes[i];
        if (!s.shown) continue;
        int line = t.size;
        (t << sceneName(i)).padTo(line + 11) << s.traced;
        t.padTo(line + 19) << s.between;
        t.padTo(line + 28) << s.shown;
        t.padTo(line + 35) << s.missed;
        const Histogram *times[] = {&s.trace, &s.make, &s.present};
        for (int k = 0; k < 3; ++k) {
            t.padTo(line + 43 + 16 * k).decimal(times[k]->quantile(0.5), 1);
            t.padTo(line + 50 + 16 * k).decimal(times[k]->quantile(0.95), 1);
        }
        int traced = s.traced + !s.traced;
        t.padTo(line + 91).decimal(s.samples / traced, 2);
        t.padTo(line + 106).decimal(s.width / traced, 0) << '\n';
    }
    int count = 0, median = 0, most = 0, seen = 0;
    for (int times : clock.errors) count += times;
    for (int i = 0; i < FilmClock::kErrors && count; ++i) {
        seen += clock.errors[i];
        if (seen * 2 <= count) median = i + 1;
        if (seen * 20 <= count * 19) most = i + 1;
    }
    if (count) t << "sound off by ms: median below " << median + 1 << ", p95 below " << most + 1 << '\n';
    t << "(missed: sixtieths of a second without a new picture)\n";
    return writeOutput("-", t.data, (size_t)t.size);
}

} // namespace odraz

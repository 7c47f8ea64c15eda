#include "tools/measure/bench/screening.h"

#include "play/governor.h"
#include "tools/common/text.h"
#include "trace/picture/development.h"

#include <algorithm>

namespace odraz::measure {

MeasuredFilm::MeasuredFilm(IntroSettings settings, Workers &workers, bool hall)
    : memory((settings.hall = hall, memoryNeeded(settings, workers.count))) {
    Gl gl = hall ? openGl() : Gl{};
    if (const char *wrong = load(intro, settings, memory.arena, workers, kDrawnHemicubes, &gl))
        throw std::runtime_error(wrong);
}

std::vector<uint8_t> rgbOf(const Picture &p) {
    std::vector<uint8_t> rgb((size_t)p.width * (size_t)p.height * 3);
    for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = p.rgba[i / 3 * 4 + i % 3];
    return rgb;
}

Quality qualityOf(float level) {
    Governor governor;
    governor.coarseness = level;
    return governor.quality();
}

std::vector<Span> shots() {
    std::vector<Span> all;
    for (int i = 0; i < kFilm.count; ++i) {
        float end = i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow;
        all.push_back({kFilm.shots[i].scene, (double)kFilm.shots[i].row / kRowsPerSecond,
                       (double)end / kRowsPerSecond});
    }
    return all;
}

std::vector<Span> shotsOf(const std::string &scene) {
    std::vector<Span> all;
    for (const Span &shot : shots())
        if (scene == kScenes[shot.scene].name) all.push_back(shot);
    if (all.empty()) throw common::Refused("the film plays no scene '" + scene + "'");
    return all;
}

std::vector<Span> windowsIn(const Span &span, int count, double length) {
    std::vector<Span> all;
    for (int i = 0; i < count; ++i) {
        double begin =
            std::max(span.from, span.from + (span.to - span.from) * (i + 0.5) / count - length / 2);
        all.push_back({span.scene, begin, std::min(span.to, begin + length)});
    }
    return all;
}

void sizeOption(common::CommandLine &line, const std::string &name, IntroSettings &to,
                const std::string &what) {
    std::string usual = to.width ? common::format(" (default %dx%d)", to.width, to.height) : "";
    line.option(
        name, "WxH", [&to, name](const std::string &text) { to = sizeFrom(name, text); }, what + usual);
}

IntroSettings sizeFrom(const std::string &option, const std::string &text) {
    auto [width, height] = common::sizeOf(option, text, {kMaxWidth, kMaxHeight});
    return {width, height};
}

} // namespace odraz::measure

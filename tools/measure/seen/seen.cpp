// seen: what a viewer sees of a played film, at every sixtieth of a second.
#include "tools/common/whole_file.h"
#include "tools/measure/seen/simulated.h"
#include "tools/measure/seen/viewer.h"

#include <cmath>
#include <cstdio>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: seen LIST [--scene NAME]... [--windows N=1] [--at S]... [--length S=0.5]\n"
    "            [--screen WxH=1280x720] [--judged WxH] [--summary]\n"
    "       seen --steady RATE [--pairs] [--level L=1] [--traced WxH] [--list] ...\n"
    "       seen --machine G [--cores N] [--costs FILE] [--pixels L] [--thirty L] [--list] ...\n"
    "Compares what stands on the screen at every sixtieth of a second with the film's picture of that very\n"
    "moment, at the quality `film`: mean FLIP, and PSNR in linear light and in sRGB, in dB.\n"
    "LIST says which pictures were shown, and when (CSV: at,time,kind,level,width,height). --steady is a\n"
    "player that never misses: RATE pictures a second, with --pairs every other one made between two; of a\n"
    "level from 0 (film) over 1 (play) to 2 (draft); traced in other pixels than the screen has. --machine "
    "is\n"
    "the film's own player, simulated on a machine of so many 10^9 instructions a second in all and so many\n"
    "cores (of 7 each, if --cores does not say), with counted costs. --pixels and --thirty change what all\n"
    "scenes would rather do without (Pace in intro.h). --list only writes the list; --summary\n"
    "only tells what was shown, by scene. --judged looks at a smaller screen, with all pictures smaller\n"
    "alike, which is faster.\n"
    "Each shot has --windows windows of --length seconds, evenly spaced; or there are windows that begin\n"
    "--at a moment. Pictures traced in fewer pixels than the screen has are scaled up as the film does it.\n"
    "Writes a CSV to stdout; \"fresh\" counts new pictures.\n";

namespace {

constexpr double kCore = 7e9; // instructions a second that a core does, where nothing else is said

struct Asked {
    std::string list, screen = "1280x720", traced, judged, costs = kCostsFile;
    std::vector<std::string> scenes;
    std::vector<double> at;
    int windows = 1, cores = 0;
    double length = 0.5, rate = 0, level = -1, machine = 0; // machine: instructions a second
    double pixels = -1, thirty = -1;                        // of all scenes' pace; negative: each has its own
    bool pairs = false, onlyList = false, onlySummary = false;
};

Asked read(Arguments &words) {
    Asked a;
    bool costs = false;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--scene")
            a.scenes.push_back(words.value(w));
        else if (w == "--windows")
            a.windows = words.whole(w, 1, 100);
        else if (w == "--at")
            a.at.push_back(words.number(w, 0, duration() - 1 / 60.));
        else if (w == "--length")
            a.length = words.number(w, 1 / 60., 10);
        else if (w == "--screen")
            a.screen = words.value(w);
        else if (w == "--judged")
            a.judged = words.value(w);
        else if (w == "--traced")
            a.traced = words.value(w);
        else if (w == "--steady")
            a.rate = words.number(w, 1, 1000);
        else if (w == "--machine")
            a.machine = words.number(w, 0.1, 1e6) * 1e9;
        else if (w == "--cores")
            a.cores = words.whole(w, 1, kMaxWorkers);
        else if (w == "--costs")
            a.costs = words.value(w), costs = true;
        else if (w == "--pixels")
            a.pixels = words.number(w, 0, 9);
        else if (w == "--thirty")
            a.thirty = words.number(w, 0, 9);
        else if (w == "--level")
            a.level = words.number(w, 0, 2);
        else if (w == "--pairs")
            a.pairs = true;
        else if (w == "--list")
            a.onlyList = true;
        else if (w == "--summary")
            a.onlySummary = true;
        else if (word[0] == '-' || !a.list.empty())
            words.refuse(w);
        else
            a.list = w;
    }
    if (!a.list.empty() + (a.rate > 0) + (a.machine > 0) != 1)
        throw Refused("name a list, or a rate with --steady, or a --machine; see seen --help");
    if (!a.rate && (a.pairs || a.level >= 0 || !a.traced.empty()))
        throw Refused("--pairs, --level and --traced go with --steady");
    if (!a.machine && (a.cores || a.pixels >= 0 || a.thirty >= 0))
        throw Refused("--cores, --pixels and --thirty go with --machine");
    if (!a.machine && !a.onlySummary && costs) throw Refused("--costs goes with --machine or --summary");
    if (a.onlyList && !a.list.empty()) throw Refused("--list goes with --steady or --machine");
    if (!a.cores) a.cores = std::clamp((int)std::lround(a.machine / kCore), 1, kMaxWorkers);
    if (a.level < 0) a.level = 1;
    if (a.traced.empty()) a.traced = a.screen;
    if (a.judged.empty()) a.judged = a.screen;
    if (!a.at.empty() && !a.scenes.empty()) throw Refused("--at tells the scene: leave out --scene");
    if (a.scenes.empty() && a.at.empty())
        for (const SceneEntry &s : kScenes) a.scenes.push_back(s.name);
    return a;
}

// A file that must hold what `parse` understands.
template <class Parse> auto parsed(const std::string &path, Parse parse) {
    std::string text = readWhole(path);
    try {
        return parse(text);
    } catch (const Refused &why) {
        throw Refused(path + ": " + why.what());
    }
}

CostOf costsOf(const Asked &a) {
    Costs costs = parsed(a.costs, [](const std::string &text) { return Costs(text); });
    return [=](const Pictured &p) { return costs.of(p); };
}

Machine machineOf(const Asked &a) {
    IntroSettings screen = sizeFrom(a.screen);
    Machine machine = {a.machine, a.cores, screen.width, screen.height};
    double pixels = a.pixels, thirty = a.thirty;
    machine.paceOf = [=](int scene) {
        Pace pace = paceOf(scene);
        if (pixels >= 0) pace.pixels = (float)pixels;
        if (thirty >= 0) pace.thirty = (float)thirty;
        return pace;
    };
    return machine;
}

// The pictures shown, of which some stand on the screen between two moments.
std::vector<Shown> listOf(const Asked &a, double from, double to) {
    if (!a.list.empty()) return parsed(a.list, parseShown);
    IntroSettings traced = sizeFrom(a.traced);
    if (a.rate) return steady(from, to, a.rate, a.pairs, (float)a.level, traced.width, traced.height);
    // From the film's start, since the governor remembers
    return simulate(costsOf(a), machineOf(a), 0, duration());
}

// Where it looks: windows of the same row of the output stand together.
std::vector<std::vector<Span>> windowsOf(const Asked &a) {
    std::vector<std::vector<Span>> rows;
    for (double at : a.at) rows.push_back({{sceneAt(at), at, std::min(at + a.length, duration())}});
    for (const std::string &name : a.scenes) {
        rows.emplace_back();
        for (const Span &shot : shotsOf(name))
            for (const Span &window : windowsIn(shot, a.windows, a.length)) rows.back().push_back(window);
    }
    return rows;
}

void print(const char *scene, const Seen &s) {
    std::printf("%s,%d,%d,%.4f,%.2f,%.2f\n", scene, s.sixtieths, s.fresh, s.meanFlip(), s.linearPsnr(),
                s.srgbPsnr());
    std::fflush(stdout);
}

int run(Arguments &words) {
    Asked asked = read(words);
    IntroSettings screen = sizeFrom(asked.screen), judged = sizeFrom(asked.judged);
    std::vector<std::vector<Span>> rows = windowsOf(asked);
    double first = duration(), last = 0;
    for (const auto &row : rows)
        for (const Span &w : row) first = std::min(first, w.from), last = std::max(last, w.to);
    std::vector<Shown> list = listOf(asked, first, last);
    if (asked.onlyList || asked.onlySummary) {
        std::string text = printShown(list);
        if (asked.onlySummary) text = printSummary(summary(list, costsOf(asked), machineOf(asked)));
        std::fputs(text.c_str(), stdout);
        return 0;
    }
    for (Shown &s : list) {
        s.width = std::max(16, s.width * judged.width / screen.width);
        s.height = std::max(16, s.height * judged.height / screen.height);
    }
    Viewer viewer(judged.width, judged.height, first, last);
    Seen all;
    std::puts("scene,sixtieths,fresh,flip,linear_db,srgb_db");
    for (const auto &row : rows) {
        Seen scene;
        for (const Span &window : row) viewer.look(list, window.from, window.to, scene);
        print(sceneName(row[0].scene), scene);
        all.add(scene);
    }
    if (rows.size() > 1) print("all", all);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return runProgram("seen", kUsage, argc, argv, run); }

// seen: what a viewer sees of a played film, at every sixtieth of a second.
#include "tools/common/whole_file.h"
#include "tools/measure/detect/screening.h"
#include "tools/measure/seen/viewer.h"

#include <cstdio>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: seen LIST [--scene NAME]... [--windows N=1] [--length S=0.5] [--screen WxH=1280x720]\n"
    "       seen --steady RATE [--pairs] [--level L=1] [--traced WxH] [--list] ...\n"
    "Compares what stands on the screen at every sixtieth of a second with the film's picture of that very\n"
    "moment, at the quality `film`: mean FLIP, and PSNR in linear light and in sRGB, in dB.\n"
    "LIST says which pictures were shown, and when (CSV: at,time,kind,level,width,height). --steady is a\n"
    "player that never misses: RATE pictures a second, with --pairs every other one made between two; of a\n"
    "level from 0 (film) over 1 (play) to 2 (draft); traced in other pixels than the screen has. --list\n"
    "only writes the list of it.\n"
    "Each shot has --windows windows of --length seconds, evenly spaced. Pictures of another size than the\n"
    "screen are scaled by Catmull and Rom's cubic. Writes a CSV to stdout; \"fresh\" counts new pictures.\n";

namespace {

struct Asked {
    std::string list, screen = "1280x720", traced;
    std::vector<std::string> scenes;
    int windows = 1;
    double length = 0.5, rate = 0, level = -1;
    bool pairs = false, onlyList = false;
};

Asked read(Arguments &words) {
    Asked a;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--scene")
            a.scenes.push_back(words.value(w));
        else if (w == "--windows")
            a.windows = words.whole(w, 1, 100);
        else if (w == "--length")
            a.length = words.number(w, 1 / 60., 10);
        else if (w == "--screen")
            a.screen = words.value(w);
        else if (w == "--traced")
            a.traced = words.value(w);
        else if (w == "--steady")
            a.rate = words.number(w, 1, 1000);
        else if (w == "--level")
            a.level = words.number(w, 0, 2);
        else if (w == "--pairs")
            a.pairs = true;
        else if (w == "--list")
            a.onlyList = true;
        else if (word[0] == '-' || !a.list.empty())
            words.refuse(w);
        else
            a.list = w;
    }
    if (a.list.empty() == !a.rate) throw Refused("name a list, or a rate with --steady; see seen --help");
    if (!a.rate && (a.pairs || a.onlyList || a.level >= 0 || !a.traced.empty()))
        throw Refused("--pairs, --level, --traced and --list go with --steady");
    if (a.level < 0) a.level = 1;
    if (a.traced.empty()) a.traced = a.screen;
    if (a.scenes.empty())
        for (const SceneEntry &s : kScenes) a.scenes.push_back(s.name);
    return a;
}

struct Window {
    std::string scene;
    double from, to;
};

// Where it looks, scene by scene.
std::vector<Window> windowsOf(const Asked &a) {
    std::vector<Window> all;
    for (const std::string &scene : a.scenes) {
        size_t before = all.size();
        for (int i = 0; i < kFilm.count; ++i) {
            if (scene != kScenes[kFilm.shots[i].scene].name) continue;
            double from = (double)kFilm.shots[i].row / kRowsPerSecond,
                   to = (i + 1 < kFilm.count ? (double)kFilm.shots[i + 1].row : (double)kFilm.endRow) /
                        kRowsPerSecond;
            for (int k = 0; k < a.windows; ++k) {
                double begin = std::max(from, from + (to - from) * (k + 0.5) / a.windows - a.length / 2);
                all.push_back({scene, begin, std::min(to, begin + a.length)});
            }
        }
        if (all.size() == before) throw Refused("there is no scene '" + scene + "'");
    }
    return all;
}

void print(const char *scene, const Seen &s) {
    std::printf("%s,%d,%d,%.4f,%.2f,%.2f\n", scene, s.sixtieths, s.fresh, s.meanFlip(), s.linearPsnr(),
                s.srgbPsnr());
    std::fflush(stdout);
}

int run(Arguments &words) {
    Asked asked = read(words);
    IntroSettings screen = sizeFrom(asked.screen), traced = sizeFrom(asked.traced);
    std::vector<Window> windows = windowsOf(asked);
    double first = duration(), last = 0;
    for (const Window &w : windows) first = std::min(first, w.from), last = std::max(last, w.to);
    auto steadyFrom = [&](double from, double to) {
        return steady(from, to, asked.rate, asked.pairs, (float)asked.level, traced.width, traced.height);
    };
    if (asked.onlyList) {
        std::fputs(printShown(steadyFrom(first, last)).c_str(), stdout);
        return 0;
    }
    std::vector<Shown> list;
    if (!asked.rate) try {
            list = parseShown(readWhole(asked.list));
        } catch (const Refused &why) {
            throw Refused(asked.list + ": " + why.what());
        }
    Viewer viewer(screen.width, screen.height, first, last);
    Seen all;
    std::puts("scene,sixtieths,fresh,flip,linear_db,srgb_db");
    for (size_t i = 0; i < windows.size();) {
        Seen scene;
        const std::string &name = windows[i].scene;
        for (; i < windows.size() && windows[i].scene == name; ++i)
            viewer.look(asked.rate ? steadyFrom(windows[i].from, windows[i].to) : list, windows[i].from,
                        windows[i].to, scene);
        print(name.c_str(), scene);
        all.add(scene);
    }
    if (asked.scenes.size() > 1) print("all", all);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return runProgram("seen", kUsage, argc, argv, run); }

// seen: what a viewer sees of a played film, at every sixtieth of a second.
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/measure/seen/simulated.h"
#include "tools/measure/seen/viewer.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: seen LIST [--scene NAME]... [--windows N=1] [--at S]... [--length S=0.5]\n"
    "            [--screen WxH=1280x720] [--judged WxH] [--pictures FOLDER] [--summary]\n"
    "       seen --steady RATE [--every N=1] [--level L=1] [--traced WxH] [--list] ...\n"
    "       seen --machine G... [--screen WxH]... [--cores N] [--costs FILE]\n"
    "            [--lost P,F,S,T] [--list] ...\n"
    "Compares what stands on the screen at every sixtieth of a second with the film's picture of that very\n"
    "moment, at the quality `film`: mean FLIP, and PSNR in linear light and in sRGB, in dB.\n"
    "LIST says which pictures were shown, and when (CSV: at,time,kind,level,width,height). --steady is a\n"
    "player that never misses: RATE pictures a second, of which one of --every is traced and the others are\n"
    "made between two; of a level from 0 (film) over 1 (play) to 2 (draft); traced in other pixels than the\n"
    "screen has. --machine is the film's own player, simulated on a machine of G 10^9 instructions a second\n"
    "in all, on N cores (of 7 each, if --cores does not say), with counted costs. --lost changes\n"
    "what all scenes lose by pairs, fours, sixes and thirty (Pace in timeline/pace.h). --list only writes "
    "the list;\n"
    "--summary only prints what was shown, by scene. --judged looks at a smaller screen, with all pictures\n"
    "smaller alike, which is faster.\n"
    "Each shot has --windows windows of --length seconds, evenly spaced; or there are windows that begin\n"
    "--at a moment. Pictures traced in fewer pixels than the screen has are scaled up as the film does it.\n"
    "--pictures writes what stands on the screen, and the truth: 052000-3.png and 052000-3-truth.png are of\n"
    "the fourth sixtieth of the window that begins at 52 s.\n"
    "Writes a CSV to stdout; \"fresh\" counts new pictures. Rows of simulated players begin with the screen\n"
    "and the machine; there may be several of both, and each is simulated with each.\n";

namespace {

constexpr double kCore = 7e9; // instructions a second that a core does, where nothing else is said

struct Asked {
    std::string list, traced, judged, costs = kCostsFile, pictures;
    std::vector<std::string> scenes, screens;
    std::vector<double> at, machines; // seconds; 10^9 instructions a second
    int windows = 1, cores = 0, every = 0;
    double length = 0.5, rate = 0, level = -1;
    std::vector<float> lost; // ... by pairs, fours, sixes and thirty; empty: each has its own
    bool onlyList = false, onlySummary = false;
};

std::vector<float> lostAfter(common::Arguments &words, const std::string &option) {
    std::vector<float> lost(kCadences - 1);
    std::string text = words.value(option);
    char behind;
    static_assert(kCadences == 5);
    if (std::sscanf(text.c_str(), "%f,%f,%f,%f%c", &lost[0], &lost[1], &lost[2], &lost[3], &behind) == 4 &&
        std::all_of(lost.begin(), lost.end(), [](float l) { return l >= 0 && l <= 99; }))
        return lost;
    throw common::Refused(option + " takes four numbers from 0 to 99, as 0.2,0.8,1.5,6, not " + text);
}

Asked read(common::Arguments &words) {
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
            a.screens.push_back(words.value(w));
        else if (w == "--judged")
            a.judged = words.value(w);
        else if (w == "--pictures")
            a.pictures = words.value(w);
        else if (w == "--traced")
            a.traced = words.value(w);
        else if (w == "--steady")
            a.rate = words.number(w, 1, 1000);
        else if (w == "--machine")
            a.machines.push_back(words.number(w, 0.1, 1e6));
        else if (w == "--cores")
            a.cores = words.whole(w, 1, kMaxWorkers);
        else if (w == "--costs")
            a.costs = words.value(w), costs = true;
        else if (w == "--lost")
            a.lost = lostAfter(words, w);
        else if (w == "--level")
            a.level = words.number(w, 0, 2);
        else if (w == "--every")
            a.every = words.whole(w, 1, 60);
        else if (w == "--list")
            a.onlyList = true;
        else if (w == "--summary")
            a.onlySummary = true;
        else if (word[0] == '-' || !a.list.empty())
            words.refuse(w);
        else
            a.list = w;
    }
    bool machine = !a.machines.empty();
    if (!a.list.empty() + (a.rate > 0) + machine != 1)
        throw common::Refused("name a list, or a rate with --steady, or a --machine; see seen --help");
    if (!a.rate && (a.every || a.level >= 0 || !a.traced.empty()))
        throw common::Refused("--every, --level and --traced go with --steady");
    if (!machine && (a.cores || !a.lost.empty()))
        throw common::Refused("--cores and --lost go with --machine");
    if (!machine && !a.onlySummary && costs)
        throw common::Refused("--costs goes with --machine or --summary");
    if (a.onlyList && !a.list.empty()) throw common::Refused("--list goes with --steady or --machine");
    if (a.screens.empty()) a.screens = {"1280x720"};
    if (!machine && a.screens.size() > 1) throw common::Refused("several screens go with --machine");
    if (a.screens.size() * a.machines.size() > 1 && (a.onlyList || !a.pictures.empty()))
        throw common::Refused("--list and --pictures go with one machine and one screen");
    if (a.level < 0) a.level = 1;
    if (!a.every) a.every = 1;
    if (a.traced.empty()) a.traced = a.screens[0];
    if (a.judged.empty() && a.screens.size() > 1 && !a.onlySummary)
        throw common::Refused("several screens need --judged");
    if (a.judged.empty()) a.judged = a.screens[0];
    if (!a.at.empty() && !a.scenes.empty())
        throw common::Refused("--at says which scene it is: leave out --scene");
    if (a.scenes.empty() && a.at.empty())
        for (const SceneEntry &s : kScenes) a.scenes.push_back(s.name);
    return a;
}

// A file that must hold what `parse` understands.
template <class Parse> auto parsed(const std::string &path, Parse parse) {
    std::string text = common::readWhole(path);
    try {
        return parse(text);
    } catch (const common::Refused &why) {
        throw common::Refused(path + ": " + why.what());
    }
}

CostOf costsOf(const Asked &a) {
    Costs costs = parsed(a.costs, [](const std::string &text) { return Costs(text); });
    return [=](const Pictured &p) { return costs.of(p); };
}

// A player, and what was seen of it.
struct Player {
    std::string name, screen; // name: what its rows begin with
    Machine machine;
    std::vector<Shown> list;
    Seen scene = {}, all = {};
};

Machine machineOf(const Asked &a, double giga, const IntroSettings &screen) {
    int cores = a.cores ? a.cores : std::clamp((int)std::lround(giga * 1e9 / kCore), 1, kMaxWorkers);
    Machine machine = {giga * 1e9, cores, screen.width, screen.height};
    machine.paceOf = [=](int scene) {
        Pace pace = paceOf(scene);
        std::copy(a.lost.begin(), a.lost.end(), pace.penalty + 1);
        return pace;
    };
    return machine;
}

// All players, with the pictures that they showed, of which some stand on the screen between two moments.
std::vector<Player> playersOf(const Asked &a, double from, double to, const CostOf &costs) {
    std::vector<Player> players;
    for (const std::string &screen : a.screens) {
        IntroSettings size = sizeFrom(screen);
        for (double giga : a.machines) {
            std::string name;
            common::append(name, "%s,%g,", screen.c_str(), giga);
            Machine machine = machineOf(a, giga, size);
            // From the film's start, since the governor remembers
            players.push_back({name, screen, machine, simulate(costs, machine, 0, duration())});
        }
        if (!a.machines.empty()) continue;
        IntroSettings traced = sizeFrom(a.traced);
        players.push_back(
            {"", screen, machineOf(a, 0, size),
             a.rate ? steady(from, to, a.rate, a.every, (float)a.level, traced.width, traced.height)
                    : parsed(a.list, parseShown)});
    }
    return players;
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

void printRow(const Player &player, const char *scene, const Seen &s) {
    std::printf("%s%s,%d,%d,%.4f,%.2f,%.2f\n", player.name.c_str(), scene, s.sixtieths, s.fresh, s.meanFlip(),
                s.linearPsnr(), s.srgbPsnr());
    std::fflush(stdout);
}

// Writes what stands on the screen, and the truth, sixtieth by sixtieth of a window.
Viewer::Each writer(const std::string &folder, const Span &window, const IntroSettings &size) {
    if (folder.empty()) return {};
    return [=, n = 0](const std::vector<uint8_t> &stands, const std::vector<uint8_t> &truth) mutable {
        std::string path = folder;
        common::append(path, "/%06ld-%d", std::lround(window.from * 1000), n++);
        for (auto [rgb, end] : {std::pair(&stands, ".png"), std::pair(&truth, "-truth.png")})
            pictures::writePng(path + end, {size.width, size.height, *rgb});
    };
}

int run(common::Arguments &words) {
    Asked asked = read(words);
    IntroSettings judged = sizeFrom(asked.judged);
    std::vector<std::vector<Span>> rows = windowsOf(asked);
    double first = duration(), last = 0;
    for (const auto &row : rows)
        for (const Span &w : row) first = std::min(first, w.from), last = std::max(last, w.to);
    CostOf costs = costsOf(asked);
    std::vector<Player> players = playersOf(asked, first, last, costs);
    if (asked.onlyList) {
        std::fputs(printShown(players[0].list).c_str(), stdout);
        return 0;
    }
    std::string head = asked.machines.empty() ? "" : "screen,machine,";
    if (asked.onlySummary) {
        std::puts((head + kSummaryHead).c_str());
        for (const Player &p : players)
            std::fputs(printSummary(summary(p.list, costs, p.machine), p.name).c_str(), stdout);
        return 0;
    }
    for (Player &p : players) {
        IntroSettings screen = sizeFrom(p.screen);
        for (Shown &s : p.list) {
            s.width = std::max(16, s.width * judged.width / screen.width);
            s.height = std::max(16, s.height * judged.height / screen.height);
        }
    }
    if (!asked.pictures.empty()) std::filesystem::create_directories(asked.pictures);
    Viewer viewer(judged.width, judged.height, first, last);
    std::puts((head + "scene,sixtieths,fresh,flip,linear_db,srgb_db").c_str());
    for (const auto &row : rows) {
        // All players of a window, since they share the truth
        for (const Span &window : row)
            for (Player &p : players)
                viewer.look(p.list, window.from, window.to, p.scene, writer(asked.pictures, window, judged));
        for (Player &p : players) {
            printRow(p, sceneName(row[0].scene), p.scene);
            p.all.add(p.scene);
            p.scene = {};
        }
    }
    if (rows.size() > 1)
        for (const Player &p : players) printRow(p, "all", p.all);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("seen", kUsage, argc, argv, run); }

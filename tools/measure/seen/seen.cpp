// seen: what a viewer sees of a played film, at every sixtieth of a second.
#include "play/page_player.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/measure/seen/simulated.h"
#include "tools/measure/seen/viewer.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace odraz::measure {

namespace {

constexpr double kCore = 7e9; // instructions a second of a core, without --cores

struct Options {
    std::string list, pictures;
    std::vector<std::string> scenes, screens;
    IntroSettings judged = {};
    std::vector<double> at, machines; // seconds; 10^9 instructions a second
    int windows = 1, cores = 0;
    double length = 0.5, page = 0; // page: how many times as much a picture costs there; 0: not the page
    bool onlyList = false, onlySummary = false;
};

common::CommandLine::Take numbersTo(std::vector<double> &to, const std::string &option, common::Range range) {
    return [&to, option, range](const std::string &text) {
        to.push_back(common::numberOf(option, text, range));
    };
}

// Refuses options that do not go with each other, and fills in what follows from others.
void check(const common::CommandLine &line, Options &o) {
    bool machine = !o.machines.empty();
    auto goes = [&](const char *option, bool with, const char *what) {
        if (line.has(option) && !with) line.refuse(std::string(option) + " goes with " + what);
    };
    if (o.list.empty() != machine) line.refuse("name a list, or --machine");
    goes("--cores", machine, "--machine");
    goes("--page", machine, "--machine");
    goes("--list", machine, "--machine");
    if (o.screens.empty()) o.screens = {"1280x720"};
    bool several = o.screens.size() > 1;
    if (several && !machine) line.refuse("several screens go with --machine");
    if (several && !o.judged.width && !o.onlySummary) line.refuse("several screens need --judged");
    for (const char *option : {"--list", "--pictures"})
        goes(option, o.screens.size() * o.machines.size() <= 1, "one machine and one screen");
    goes("--scene", o.at.empty(), "its own windows: leave out --at");
    if (!o.judged.width) o.judged = sizeFrom("--screen", o.screens[0]);
    if (o.scenes.empty() && o.at.empty())
        for (const SceneEntry &s : kScenes) o.scenes.push_back(s.name);
}

Options read(common::CommandLine &line) {
    Options o;
    line.about("Compares the picture on the screen at every sixtieth of a second with the film's picture of "
               "that\n"
               "moment, at the quality `film`: mean FLIP, and PSNR in linear light and in sRGB, in dB. "
               "Prints a CSV.");
    line.argument("LIST", o.list, "the pictures that were shown, as odraz-debug --shown writes them", false);
    line.option("--screen", "WxH", o.screens, "the screen (default 1280x720); with --machine");
    sizeOption(line, "--judged", o.judged,
               "look at a smaller screen, with all pictures smaller alike: faster");
    line.option("--scene", "NAME", o.scenes, "look at this scene (default: all)");
    line.option("--windows", "N", o.windows, {1, 100}, "windows in each shot, evenly spaced");
    line.option("--length", "S", o.length, {1 / 60., 10}, "the length of a window");
    line.option("--at", "S", numbersTo(o.at, "--at", {0, duration() - 1 / 60.}),
                "a window that begins at this moment; repeatable");
    line.flag("--list", o.onlyList, "only print the list of pictures");
    line.flag("--summary", o.onlySummary, "only print what was shown, by scene");
    line.option(
        "--pictures", "FOLDER", o.pictures,
        "write the pictures on the screen, and the truth: 052000-3.png and 052000-3-truth.png are of the "
        "fourth sixtieth of the window at 52 s");
    line.group("The film's own player on a simulated machine, instead of LIST");
    line.option("--machine", "G", numbersTo(o.machines, "--machine", {0.1, 1e6}),
                "10^9 instructions a second of all cores; repeatable");
    line.option("--cores", "N", o.cores, {1, kMaxWorkers}, "its cores (default: of 7 G each)");
    line.option("--page", "TIMES", o.page, {0.1, 100},
                "the page's player instead, where a picture costs that many times as much");
    line.parse();
    check(line, o);
    return o;
}

CostOf countedCosts() {
    Costs costs = common::parseFile(kCostsFile, [](const std::string &text) { return Costs(text); });
    return [=](const Pictured &p) { return costs.of(p); };
}

// A player, and what was seen of it.
struct Player {
    std::string name, screen; // name: what its rows begin with
    Machine machine;
    std::vector<Shown> list;
    Seen scene = {}, all = {};
};

Machine machineOf(const Options &o, double giga, const IntroSettings &screen) {
    int cores = o.cores ? o.cores : std::clamp((int)std::lround(giga * 1e9 / kCore), 1, kMaxWorkers);
    Machine machine = {giga * 1e9, cores, screen.width, screen.height};
    if (o.page > 0) {
        machine.rate /= o.page;
        machine.workers = pageWorkers(cores);
    }
    return machine;
}

// All players, with the pictures that they showed.
std::vector<Player> playersOf(const Options &o, const CostOf &costs) {
    std::vector<Player> players;
    for (const std::string &screen : o.screens) {
        IntroSettings size = sizeFrom("--screen", screen);
        for (double giga : o.machines) {
            std::string name = common::format("%s,%g,", screen.c_str(), giga);
            Machine machine = machineOf(o, giga, size);
            // From the film's start, since the governor remembers
            players.push_back({name, screen, machine, simulate(costs, machine, 0, duration())});
        }
        if (!o.machines.empty()) continue;
        players.push_back({"", screen, machineOf(o, 0, size), common::parseFile(o.list, parseShown)});
    }
    return players;
}

// The windows to look at, a vector for each row of the output.
std::vector<std::vector<Span>> windowsOf(const Options &o) {
    std::vector<std::vector<Span>> rows;
    for (double at : o.at) rows.push_back({{sceneAt(at), at, std::min(at + o.length, duration())}});
    for (const std::string &name : o.scenes) {
        rows.emplace_back();
        for (const Span &shot : shotsOf(name))
            for (const Span &window : windowsIn(shot, o.windows, o.length)) rows.back().push_back(window);
    }
    return rows;
}

void printRow(const Player &player, const char *scene, const Seen &s) {
    std::printf("%s%s,%d,%d,%.4f,%.2f,%.2f\n", player.name.c_str(), scene, s.sixtieths, s.fresh, s.meanFlip(),
                s.linearPsnr(), s.srgbPsnr());
    std::fflush(stdout);
}

// Writes the picture on the screen, and the truth, for each sixtieth of a window.
Viewer::Each writer(const std::string &folder, const Span &window, const IntroSettings &size) {
    if (folder.empty()) return {};
    return [=, n = 0](const std::vector<uint8_t> &shown, const std::vector<uint8_t> &truth) mutable {
        std::string path =
            common::format("%s/%06ld-%d", folder.c_str(), std::lround(window.from * 1000), n++);
        for (auto [rgb, end] : {std::pair(&shown, ".png"), std::pair(&truth, "-truth.png")})
            pictures::writePng(path + end, {size.width, size.height, *rgb});
    };
}

int run(common::CommandLine &line) {
    Options asked = read(line);
    const IntroSettings &judged = asked.judged;
    std::vector<std::vector<Span>> rows = windowsOf(asked);
    double first = duration(), last = 0;
    for (const auto &row : rows)
        for (const Span &w : row) first = std::min(first, w.from), last = std::max(last, w.to);
    CostOf costs = countedCosts();
    std::vector<Player> players = playersOf(asked, costs);
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
        IntroSettings screen = sizeFrom("--screen", p.screen);
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

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("seen", argc, argv, odraz::measure::run); }

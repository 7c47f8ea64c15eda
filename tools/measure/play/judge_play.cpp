// judge_play: compares the picture on the screen with the film, at every sixtieth of a second.
#include "play/page_player.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/measure/play/simulated.h"
#include "tools/measure/play/viewer.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace odraz::measure {

namespace {

constexpr double kCore = 7e9; // instructions a second of a core, if --cores is not given

struct JudgeOptions {
    std::string list, pictures, crops;
    std::vector<std::string> scenes, screens;
    IntroSettings judged = {}, corner = {};
    std::vector<double> at, machines; // seconds; 10^9 instructions a second
    int cores = 0;
    double length = 0.5; // seconds of a window
    double page = 0;     // cost of a picture on the page relative to the native film; 0: not the page
    double since = 0;    // first second of the summary
    bool simulates = false, onlySummary = false;
};

common::CommandLine::Read numbersTo(std::vector<double> &to, const std::string &option, common::Range range) {
    return [&to, option, range](const std::string &text) {
        to.push_back(common::numberOf(option, text, range));
    };
}

// Refuses options that exclude each other, and sets defaults that depend on other options.
void check(const common::CommandLine &line, JudgeOptions &o) {
    bool machine = !o.machines.empty();
    auto needs = [&](const char *option, bool met, const char *what) {
        if (line.has(option) && !met) line.refuse(std::string(option) + " needs " + what);
    };
    if (o.list.empty() != machine) line.refuse("give either a list or --machine");
    needs("--cores", machine || o.simulates, "--machine or --simulate");
    needs("--simulate", !machine && o.onlySummary, "a list and --summary");
    needs("--since", o.onlySummary, "--summary");
    needs("--page", machine, "--machine");
    needs("--crops", o.at.size() == 1, "a single --at");
    needs("--corner", line.has("--crops"), "--crops");
    pictures::formatNamed(o.crops, pictures::Format::Jpeg); // refuses other formats
    if (o.screens.empty()) o.screens = {"1280x720"};
    bool several = o.screens.size() > 1;
    if (several && !machine) line.refuse("several screens need --machine");
    if (several && !o.judged.width && !o.onlySummary) line.refuse("several screens need --judged");
    needs("--pictures", o.screens.size() * o.machines.size() <= 1, "a single machine and screen");
    needs("--scene", o.at.empty(), "the scene's own windows: leave out --at");
    if (!o.judged.width) o.judged = sizeFrom("--screen", o.screens[0]);
    if (o.scenes.empty() && o.at.empty())
        for (const SceneEntry &s : kScenes) o.scenes.push_back(s.name);
}

JudgeOptions read(common::CommandLine &line) {
    JudgeOptions o;
    line.about("Compares the picture on the screen at every sixtieth of a second with the film's picture of "
               "that\nmoment in `film` quality: mean FLIP, and PSNR in sRGB, in dB. Prints a CSV.");
    line.argument("LIST", o.list, "the list of shown pictures that odraz-debug --shown wrote", false);
    line.option("--screen", "WxH", o.screens, "size of the screen (default 1280x720); with --machine");
    sizeOption(line, "--judged", o.judged,
               "compare at this smaller size, with all pictures shrunk alike, which is faster");
    line.option("--scene", "NAME", o.scenes, "compare this scene (default: all)");
    line.option("--length", "S", o.length, {1 / 60., 10}, "length of a window, in the middle of each shot");
    line.option("--at", "S", numbersTo(o.at, "--at", {0, duration() - 1 / 60.}),
                "compare a window that begins at this moment; repeatable");
    line.flag("--summary", o.onlySummary, "only print what was shown, by scene");
    line.option("--since", "S", o.since, {0, duration()}, "begin the summary at this second");
    line.flag("--simulate", o.simulates,
              "simulate the list's part of the film, too, on a machine that is as fast in each second");
    line.option(
        "--pictures", "FOLDER", o.pictures,
        "write the pictures on the screen and the film's: 052000-3.png and 052000-3-truth.png for the "
        "fourth sixtieth of the window at 52 s");
    line.option(
        "--crops", "OUT.jpg", o.crops,
        "write a square of the window's last picture on each machine, and of the film's, side by side");
    sizeOption(line, "--corner", o.corner, "pixels to the left of the square and above it");
    line.group("The film's own player on a simulated machine, instead of LIST");
    line.option("--machine", "G", numbersTo(o.machines, "--machine", {0.1, 1e6}),
                "10^9 instructions a second of all cores together; repeatable");
    line.option("--cores", "N", o.cores, {1, kMaxWorkers}, "number of cores (default: one per 7 G)");
    line.option("--page", "TIMES", o.page, {0.1, 100},
                "simulate the page's player, where a picture costs TIMES as much");
    line.parse();
    check(line, o);
    return o;
}

CostOf countedCosts() {
    PictureCosts costs =
        common::parseFile(kCostsFile, [](const std::string &text) { return PictureCosts(text); });
    return [=](const PictureKind &p) { return costs.of(p); };
}

// A player, the pictures that it showed, and their errors.
struct JudgedPlayer {
    std::string name, screen; // name: its first columns in the output
    SimulatedMachine machine;
    std::vector<ShownPicture> list;
    SeenErrors scene = {}, all = {};
};

SimulatedMachine machineOf(const JudgeOptions &o, double giga, const IntroSettings &screen) {
    int cores = o.cores ? o.cores : std::clamp((int)std::lround(giga * 1e9 / kCore), 1, kMaxWorkers);
    SimulatedMachine machine = {giga * 1e9, cores, screen.width, screen.height};
    if (o.page > 0) {
        machine.rate /= o.page;
        machine.workers = pageWorkers(cores);
    }
    return machine;
}

std::vector<JudgedPlayer> playersOf(const JudgeOptions &o, const CostOf &costs) {
    std::vector<JudgedPlayer> players;
    for (const std::string &screen : o.screens) {
        IntroSettings size = sizeFrom("--screen", screen);
        for (double giga : o.machines) {
            std::string name = common::format("%s,%g,", screen.c_str(), giga);
            SimulatedMachine machine = machineOf(o, giga, size);
            // Simulate from the film's start, since the governor depends on the past
            players.push_back({name, screen, machine, simulate(costs, machine, 0, duration())});
        }
        if (!o.machines.empty()) continue;
        SimulatedMachine machine = machineOf(o, 0, size);
        std::vector<ShownPicture> list = common::parseFile(o.list, parseShown);
        players.push_back({o.simulates ? "played," : "", screen, machine, list});
        if (!o.simulates) continue;
        machine.rateAt = ratesOf(list, costs, machine);
        list = simulate(costs, machine, list.front().time, list.back().time + 1 / 60.);
        players.push_back({"simulated,", screen, machine, list});
    }
    return players;
}

// The windows to compare: a vector for each row of the output.
std::vector<std::vector<Span>> windowsOf(const JudgeOptions &o) {
    std::vector<std::vector<Span>> rows;
    for (double at : o.at) rows.push_back({{sceneAt(at), at, std::min(at + o.length, duration())}});
    for (const std::string &name : o.scenes) {
        rows.emplace_back();
        for (const Span &shot : shotsOf(name)) rows.back().push_back(windowsIn(shot, 1, o.length)[0]);
    }
    return rows;
}

void printRow(const JudgedPlayer &player, const char *scene, const SeenErrors &s) {
    std::printf("%s%s,%d,%d,%.4f,%.2f\n", player.name.c_str(), scene, s.sixtieths, s.fresh, s.meanFlip(),
                s.srgbPsnr());
    std::fflush(stdout);
}

// Writes the picture on the screen and the film's for each sixtieth of a window.
Viewer::Each writer(const std::string &folder, const Span &window, const IntroSettings &size) {
    if (folder.empty()) return {};
    return [=, n = 0](const std::vector<uint8_t> &shown, const std::vector<uint8_t> &truth) mutable {
        std::string path =
            common::format("%s/%06ld-%d", folder.c_str(), std::lround(window.from * 1000), n++);
        for (auto [rgb, end] : {std::pair(&shown, ".png"), std::pair(&truth, "-truth.png")})
            pictures::writePng(path + end, {size.width, size.height, *rgb});
    };
}

// A square of each picture, side by side.
pictures::Image cropped(const std::vector<std::vector<uint8_t>> &screens, const IntroSettings &size,
                        const IntroSettings &corner) {
    constexpr int kSide = 288, kGap = 6;
    common::need(corner.width + kSide <= size.width && corner.height + kSide <= size.height,
                 common::format("a square of %d pixels does not fit there", kSide));
    int wide = (kSide + kGap) * (int)screens.size() - kGap;
    pictures::Image all = {wide, kSide, std::vector<uint8_t>((size_t)(wide * kSide * 3), 255)};
    for (int i = 0; i < (int)screens.size(); ++i)
        for (int y = 0; y < kSide; ++y)
            std::copy_n(&screens[(size_t)i][(size_t)((corner.height + y) * size.width + corner.width) * 3],
                        kSide * 3, &all.rgb[(size_t)(y * wide + i * (kSide + kGap)) * 3]);
    return all;
}

int run(common::CommandLine &line) {
    JudgeOptions asked = read(line);
    const IntroSettings &judged = asked.judged;
    std::vector<std::vector<Span>> rows = windowsOf(asked);
    double first = duration(), last = 0;
    for (const auto &row : rows)
        for (const Span &w : row) first = std::min(first, w.from), last = std::max(last, w.to);
    CostOf costs = countedCosts();
    std::vector<JudgedPlayer> players = playersOf(asked, costs);
    std::string head = asked.simulates ? "player," : asked.machines.empty() ? "" : "screen,machine,";
    if (asked.onlySummary) {
        std::puts((head + kSummaryHead).c_str());
        for (const JudgedPlayer &p : players)
            std::fputs(printSummary(summary(p.list, costs, p.machine, asked.since), p.name).c_str(), stdout);
        return 0;
    }
    for (JudgedPlayer &p : players) {
        IntroSettings screen = sizeFrom("--screen", p.screen);
        for (ShownPicture &s : p.list) {
            s.width = std::max(16, s.width * judged.width / screen.width);
            s.height = std::max(16, s.height * judged.height / screen.height);
        }
    }
    if (!asked.pictures.empty()) std::filesystem::create_directories(asked.pictures);
    Viewer viewer(judged.width, judged.height, first, last);
    std::vector<std::vector<uint8_t>> screens(players.size() + 1); // what each player shows, and the film
    std::puts((head + "scene,sixtieths,fresh,flip,srgb_db").c_str());
    for (const auto &row : rows) {
        // Compare all players in a window before the next one, since they share the film's pictures
        for (const Span &window : row)
            for (size_t i = 0; i < players.size(); ++i) {
                Viewer::Each keep = [&](auto &shown, auto &truth) {
                    screens[i] = shown, screens.back() = truth;
                };
                viewer.compare(players[i].list, window.from, window.to, players[i].scene,
                               asked.crops.empty() ? writer(asked.pictures, window, judged) : keep);
            }
        for (JudgedPlayer &p : players) {
            printRow(p, sceneName(row[0].scene), p.scene);
            p.all.add(p.scene);
            p.scene = {};
        }
    }
    if (!asked.crops.empty()) pictures::writeImage(asked.crops, cropped(screens, judged, asked.corner));
    if (rows.size() > 1)
        for (const JudgedPlayer &p : players) printRow(p, "all", p.all);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("judge_play", argc, argv, odraz::measure::run); }

#include "record.h"

#include "host/clock.h"
#include "host/cpu.h"
#include "host/process.h"
#include "host/threads.h"
#include "output/output.h"
#include "play/player.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

namespace odraz {

namespace {

struct ShownPicture {
    FinishedPicture made;
    double at;
    bool between() const { return made.trace == 0; }
};

using Rows = std::vector<ShownPicture>;
void addRow(void *rows, const FinishedPicture &made, double at) { ((Rows *)rows)->push_back({made, at}); }

std::string listOf(Rows rows) {
    // An in-between needs the traced pictures on both sides, and has the level and size of the later one
    while (!rows.empty() && rows.back().between()) rows.pop_back();
    // Make times ascend: if the machine stalled, the film's clock was set back after a picture was shown
    double next = INFINITY;
    for (size_t i = rows.size(); i--;)
        if (rows[i].at >= 0) next = rows[i].at = std::min(rows[i].at, next);
    std::string text = "at,time,kind,level,width,height,seconds\n";
    for (size_t i = 0; i < rows.size(); ++i) {
        const ShownPicture &row = rows[i];
        size_t later = i;
        while (rows[later].between()) ++later;
        const FinishedPicture &traced = rows[later].made;
        char line[160];
        std::snprintf(line, sizeof line, "%.6f,%.6f,%s,%.4f,%d,%d,%.6f\n", row.at, row.made.time,
                      row.between() ? "between" : "traced", (double)traced.level, traced.size.width,
                      traced.size.height, (double)(row.made.trace + row.made.make));
        text += line;
    }
    return text;
}

} // namespace

// Checks the options and the output before the film is played. Returns an exit status.
static int checkOptions(const Options &o, const char *to) {
    const char *wrong = nullptr;
    if (o.dump || o.wav) wrong = "--shown plays the film: leave out --dump and --wav";
    if (o.quality != QualityName::Count) wrong = "--shown plays as the governor decides: leave out --quality";
    if (o.stats && isStdout(to)) wrong = "--shown - and --stats cannot both go to standard output";
    if (wrong) return printError(wrong), 2;
    int closed = prepareDescriptors();
    if (int status = checkOutput(to, closed & 2)) return status;
    std::string folder = to;
    folder = folder.find('/') == std::string::npos ? "." : folder.substr(0, folder.rfind('/') + 1);
    return !isStdout(to) && access(folder.c_str(), W_OK) ? cannotWrite(to, std::strerror(errno)) : 0;
}

int recordShown(const Options &o, const char *to) {
    if (int status = checkOptions(o, to)) return status;
    int64_t began = nanoseconds();
    static int leave = 0; // the window's thread sets it
    static Workers workers;
    int count = o.threads ? o.threads : cpuCount();
    if (const char *missing = startWorkers(workers, count, &leave)) return printError(missing);
    IntroSettings settings = {o.width, o.height};
    settings.pairs = true;
    settings.hall = needsHall(seconds(o.from), seconds(o.to));
    size_t bytes = memoryNeeded(settings, workers.count) + soundMemory();
    Arena arena = {(unsigned char *)takeMemory(bytes), bytes, 0};
    if (!arena.base) return printError("not enough memory: try a smaller --size");
    static FilmWindow window;
    {
        Quiet libraries;
        if (const char *wrong = openWindow(window, false, o.width, o.height, &leave))
            return printError(wrong);
    }
    Intro *intro;
    if (const char *wrong =
            load(intro, settings, arena, workers, kDrawnHemicubes, &window.gl, {showLoading, &window, 0}))
        return printError(wrong);
    Rows rows;
    Recorder recorder = {addRow, &rows};
    if (int status = play(*intro, o.mute ? nullptr : loadSound(arena), o, window, &leave, began, &recorder))
        return status;
    std::string text = listOf(rows);
    return writeOutput(to, text.data(), text.size());
}

} // namespace odraz

// contact_sheet: the film on one page, a frame every few seconds, each with its time.
#include "show/font.h"
#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"
#include "tools/picture/picture.h"

#include <cstring>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: contact_sheet ODRAZ OUT.png [--every SECONDS=5] [--columns N=5] [--width PIXELS=384] [--quality "
    "NAME=play]\n"
    "Lets the program ODRAZ dump a frame every so many seconds and lays them out, PIXELS wide each.\n";

static std::string quoted(const std::string &s) {
    std::string q = "'";
    for (char c : s) q += c == '\'' ? "'\\''" : std::string(1, c);
    return q + "'";
}

// Writes minutes:seconds into the picture's lower left corner, with the film's own lettering.
static void label(Picture &picture, int seconds) {
    char text[16];
    std::snprintf(text, sizeof text, "%d:%02d", seconds / 60, seconds % 60);
    static constexpr int kWidth = 64, kHeight = 20;
    static float planes[3][kWidth * kHeight];
    std::memset(planes, 0, sizeof planes);
    Frame frame = {kWidth, kHeight, kWidth, {planes[0], planes[1], planes[2]}, nullptr, nullptr};
    drawText(frame, text, 5, 15, 10, 0.13f, 1, Align::Left, {1, 1, 1}, 1);
    for (int y = 0; y < kHeight && y < picture.height; ++y)
        for (int x = 0; x < kWidth && x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) {
                uint8_t &p = picture.rgb[((size_t)(picture.height - std::min(kHeight, picture.height) + y) *
                                              (size_t)picture.width +
                                          (size_t)x) *
                                             3 +
                                         (size_t)c];
                p = (uint8_t)((float)p * 0.75f + (230 - (float)p * 0.75f) * planes[0][y * kWidth + x]);
            }
}

static std::vector<Picture> framesOf(const std::string &program, int every, int width,
                                     const std::string &quality) {
    // Trace twice as large as shown: the averaging smooths once more
    int traced = width * 2;
    std::string command = quoted(program) + " --dump - --fps 1/" + std::to_string(every) + " --quality " +
                          quoted(quality) + " --size " + std::to_string(traced) + "x" +
                          std::to_string(traced * 9 / 16);
    std::FILE *film = popen(command.c_str(), "r");
    if (!film) throw std::runtime_error("cannot run " + program);
    std::vector<Picture> frames;
    Picture frame;
    while (readPpm(film, frame)) {
        frames.push_back(shrink(frame, width));
        label(frames.back(), every * ((int)frames.size() - 1));
    }
    if (pclose(film) != 0 || frames.empty()) throw std::runtime_error(program + " did not dump the film");
    return frames;
}

// Frames of one size, row by row.
static Picture layOut(const std::vector<Picture> &frames, int columns) {
    constexpr int kGap = 6;
    const int width = frames[0].width, height = frames[0].height;
    int rows = ((int)frames.size() + columns - 1) / columns;
    Picture sheet;
    sheet.width = columns * (width + kGap) + kGap;
    sheet.height = rows * (height + kGap) + kGap;
    sheet.rgb.assign((size_t)sheet.width * (size_t)sheet.height * 3, 24);
    for (size_t i = 0; i < frames.size(); ++i) {
        size_t x = (i % (size_t)columns) * (size_t)(width + kGap) + kGap,
               y = (i / (size_t)columns) * (size_t)(height + kGap) + kGap;
        for (size_t row = 0; row < (size_t)height; ++row)
            std::memcpy(&sheet.rgb[((y + row) * (size_t)sheet.width + x) * 3],
                        &frames[i].rgb[row * (size_t)width * 3], (size_t)width * 3);
    }
    return sheet;
}

static int run(Arguments &words) {
    std::vector<std::string> paths;
    std::string quality = "play";
    int every = 5, columns = 5, width = 384;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--every")
            every = words.whole(w, 1, 4000);
        else if (w == "--columns")
            columns = words.whole(w, 1, 4000);
        else if (w == "--width")
            width = words.whole(w, 1, 4000);
        else if (w == "--quality")
            quality = words.value(w);
        else if (word[0] != '-' && paths.size() < 2)
            paths.push_back(w);
        else
            words.refuse(w);
    }
    if (paths.size() < 2) throw Refused("a program and a PNG to write are needed; see contact_sheet --help");
    checkWritable(paths[1]);
    std::vector<Picture> frames = framesOf(paths[0], every, width, quality);
    if (!writePng(paths[1], layOut(frames, columns))) throw std::runtime_error("cannot write " + paths[1]);
    std::printf("%s: %zu frames, one every %d s\n", paths[1].c_str(), frames.size(), every);
    return 0;
}

int main(int argc, char **argv) { return runProgram("contact_sheet", kUsage, argc, argv, run); }

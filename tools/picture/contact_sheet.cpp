// contact_sheet: the film on one page, a frame every few seconds, each with its time.
#include "tools/picture/picture.h"
#include "show/font.h"

#include <cstdlib>
#include <cstring>

static constexpr char kUsage[] =
    "usage: contact_sheet ODRAZ OUT.png [--every SECONDS=5] [--columns N=5] [--width PIXELS=384] [--quality "
    "NAME=play]\n"
    "Lets the program ODRAZ dump a frame every so many seconds and lays them out, PIXELS wide each.";

static int refuse(const std::string &line, int status) {
    std::fprintf(stderr, "contact_sheet: %s\n", line.c_str());
    return status;
}

static std::string quoted(const std::string &s) {
    std::string q = "'";
    for (char c : s) q += c == '\'' ? "'\\''" : std::string(1, c);
    return q + "'";
}

// Writes minutes:seconds into the picture's lower left corner, with the film's own lettering.
static void label(Picture &picture, int seconds) {
    using namespace odraz;
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

int main(int argc, char **argv) {
    std::string paths[2], quality = "play";
    int given = 0;
    long every = 5, columns = 5, width = 384;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--help")) return std::printf("%s\n", kUsage), 0;
        long *number = !std::strcmp(argv[i], "--every")     ? &every
                       : !std::strcmp(argv[i], "--columns") ? &columns
                       : !std::strcmp(argv[i], "--width")   ? &width
                                                            : nullptr;
        if (number && i + 1 < argc) {
            char *end;
            *number = std::strtol(argv[++i], &end, 10);
            if (*end || *number < 1 || *number > 4000)
                return refuse(
                    std::string(argv[i - 1]) + " needs a number from 1 to 4000, not '" + argv[i] + "'", 2);
        } else if (!std::strcmp(argv[i], "--quality") && i + 1 < argc)
            quality = argv[++i];
        else if (argv[i][0] != '-' && given < 2)
            paths[given++] = argv[i];
        else
            return refuse(std::string("cannot use '") + argv[i] + "'; see contact_sheet --help", 2);
    }
    if (given != 2) return refuse("a program and a PNG to write are needed; see contact_sheet --help", 2);

    // Trace twice as large as shown: the averaging smooths once more
    int traced = (int)width * 2;
    std::string command = quoted(paths[0]) + " --dump - --fps 1/" + std::to_string(every) + " --quality " +
                          quoted(quality) + " --size " + std::to_string(traced) + "x" +
                          std::to_string(traced * 9 / 16);
    std::FILE *film = popen(command.c_str(), "r");
    if (!film) return refuse("cannot run " + paths[0], 1);
    std::vector<Picture> frames;
    Picture frame;
    while (readPpm(film, frame)) {
        frames.push_back(shrink(frame, (int)width));
        label(frames.back(), (int)(every * (long)(frames.size() - 1)));
    }
    if (pclose(film) != 0 || frames.empty()) return refuse(paths[0] + " did not dump the film", 1);

    constexpr int kGap = 6;
    long rows = ((long)frames.size() + columns - 1) / columns;
    Picture sheet;
    sheet.width = (int)(columns * (width + kGap) + kGap);
    sheet.height = (int)rows * (frames[0].height + kGap) + kGap;
    sheet.rgb.assign((size_t)sheet.width * (size_t)sheet.height * 3, 24);
    for (size_t i = 0; i < frames.size(); ++i) {
        size_t x = (i % (size_t)columns) * (size_t)(width + kGap) + kGap,
               y = (i / (size_t)columns) * (size_t)(frames[0].height + kGap) + kGap;
        for (size_t row = 0; row < (size_t)frames[i].height; ++row)
            std::memcpy(&sheet.rgb[((y + row) * (size_t)sheet.width + x) * 3],
                        &frames[i].rgb[row * (size_t)frames[i].width * 3], (size_t)frames[i].width * 3);
    }
    if (!writePng(paths[1], sheet)) return refuse("cannot write " + paths[1], 1);
    std::printf("%s: %zu frames, one every %ld s\n", paths[1].c_str(), frames.size(), every);
    return 0;
}

// spectrogram: draws the film's music as a picture, with the film's shots.
#include "show/font.h"
#include "show/show.h"
#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"
#include "tools/measure/detect/recording.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>

namespace odraz::measure {

using pictures::Image;

static constexpr double kLow = 25, kHigh = 20000;

// Levels from black over blue and copper to white.
static void paint(Image &image, int x, int y, double level) {
    static constexpr double way[][3] = {{0, 0, 0}, {20, 40, 110}, {200, 100, 50}, {255, 245, 225}};
    level = std::clamp(level, 0., 0.9999) * 3;
    int i = (int)level;
    for (int c = 0; c < 3; ++c)
        image.rgb[((size_t)y * (size_t)image.width + (size_t)x) * 3 + (size_t)c] =
            (uint8_t)(way[i][c] + (way[i + 1][c] - way[i][c]) * (level - i));
}

static void drawLine(Image &image, int x, int y0, int y1, int grey) {
    if (x < 0 || x >= image.width) return;
    for (int y = y0; y < y1; ++y)
        for (size_t c = 0; c < 3; ++c) {
            uint8_t &p = image.rgb[((size_t)y * (size_t)image.width + (size_t)x) * 3 + c];
            p = (uint8_t)std::max((int)p, grey);
        }
}

static void label(Image &image, const char *text, int x0, int y0) {
    constexpr int kWidth = 96, kHeight = 16;
    std::vector<float> planes(3 * kWidth * kHeight);
    Frame frame = {kWidth,  kHeight,
                   kWidth,  {&planes[0], &planes[kWidth * kHeight], &planes[2 * kWidth * kHeight]},
                   nullptr, nullptr};
    drawText(frame, text, 3, 12, 9, 0.13f, 1, Align::Left, {1, 1, 1}, 1);
    for (int y = 0; y < kHeight && y0 + y < image.height; ++y)
        for (int x = 0; x < kWidth && x0 + x < image.width; ++x)
            drawLine(image, x0 + x, y0 + y, y0 + y + 1, (int)(planes[(size_t)(y * kWidth + x)] * 230));
}

static int run(common::CommandLine &line) {
    std::string wav, out;
    int second = 10, height = 600;
    line.about("Draws the film's music as a picture: time to the right, 25 Hz to 20 kHz upwards, from -110 "
               "dB (black) to\n"
               "-30 dB (white). Cuts are bright lines, accents short ones below them, octaves of 31.25 Hz "
               "dim ones.");
    line.argument("FILE.wav", wav, "what odraz --wav wrote, from the film's start");
    line.argument("OUT.png", out, "the picture to write");
    line.option("--second", "PIXELS", second, {1, 400}, "the width of a second");
    line.option("--height", "PIXELS", height, {50, 4000}, "the picture's height");
    line.parse();
    common::checkWritable(out);
    Recording r = readWav(wav);
    Image image;
    image.width = (int)((int64_t)r.size() * second / r.rate);
    image.height = height;
    if (image.width < 1) throw common::Refused(wav + " is too short");
    image.rgb.assign((size_t)image.width * (size_t)height * 3, 0);

    // A long window for low sounds, a short one for high ones
    constexpr int kSizes[] = {16384, 4096};
    for (int x = 0; x < image.width; ++x) {
        std::vector<double> energy[2];
        int64_t middle = (int64_t)x * r.rate / second;
        for (int i = 0; i < 2; ++i) energy[i] = spectrum(r, middle - kSizes[i] / 2, kSizes[i]);
        for (int y = 0; y < height; ++y) {
            double low = kLow * std::pow(kHigh / kLow, (double)(height - 1 - y) / height),
                   high = low * std::pow(kHigh / kLow, 1. / height), sum = 0;
            int which = low < 1000 ? 0 : 1;
            double perBin = (double)r.rate / kSizes[which];
            size_t from = (size_t)(low / perBin + 0.5),
                   to = std::max(from + 1, (size_t)(high / perBin + 0.5));
            for (size_t i = from; i < to; ++i) sum = std::max(sum, energy[which][i]);
            paint(image, x, y, (10 * std::log10(sum + 1e-20) + 110) / 80);
        }
    }
    for (double octave = 31.25; octave < kHigh; octave *= 2) {
        int y = height - 1 - (int)(std::log(octave / kLow) / std::log(kHigh / kLow) * height);
        for (int x = 0; x < image.width; x += 3) drawLine(image, x, y, y + 1, 70);
        label(image, std::to_string((int)octave).c_str(), 0, y - 14);
    }
    auto column = [&](double row) { return (int)(row / kRowsPerSecond * second); };
    for (int i = 0; i < kFilm.count; ++i) {
        drawLine(image, column(kFilm.shots[i].row), 0, height, 150);
        label(image, kScenes[kFilm.shots[i].scene].name, column(kFilm.shots[i].row) + 2, 0);
        for (const Event &e : kEvents)
            if (e.heard && e.scene == kFilm.shots[i].scene)
                drawLine(image, column((double)kFilm.shots[i].storyRow + e.row), 16, 26, 220);
    }
    pictures::writePng(out, image);
    return 0;
}

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("spectrogram", argc, argv, odraz::measure::run); }

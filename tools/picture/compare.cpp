// compare: measures how much two pictures differ.
#include "tools/common/command_line.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/picture/flip.h"
#include "tools/picture/picture_file.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pictures {

namespace {

struct Difference {
    double squares = 0, largest = 0; // in steps of 1/255: the sum over all channels, the largest of a channel
    size_t values = 0;               // compared, of all channels
    size_t pixels = 0, transparent = 0; // that differ, and that differ in alpha
    Image enlarged;                     // eight times
};

Difference between(const Picture &a, const Picture &b) {
    Difference all;
    size_t channels = a.hasAlpha() || b.hasAlpha() ? 4 : 3;
    all.values = a.pixels() * channels;
    all.enlarged = {a.width, a.height, std::vector<uint8_t>(a.pixels() * 3)};
    for (size_t i = 0; i < a.pixels(); ++i) {
        auto stepsA = a.steps(i), stepsB = b.steps(i);
        double d[4] = {};
        for (size_t c = 0; c < channels; ++c) {
            d[c] = std::fabs(stepsA[c] - stepsB[c]);
            all.squares += d[c] * d[c];
            all.largest = std::max(all.largest, d[c]);
        }
        all.pixels += d[0] + d[1] + d[2] + d[3] > 0;
        all.transparent += d[3] > 0;
        for (size_t c = 0; c < 3; ++c)
            all.enlarged.rgb[i * 3 + c] = (uint8_t)std::min(255., 8 * std::max(d[c], d[3]) + 0.5);
    }
    return all;
}

std::string kindOf(const Picture &p) {
    return common::format(p.light.empty() ? "%d bits" : "floats of %d bits", p.bits) +
           (p.hasAlpha() ? " and alpha" : "");
}

// The limits of --max and --psnr, and where a difference is written.
struct Settings {
    double most = 0, leastPsnr = HUGE_VAL;
    bool seen = false;
    std::string diff;
};

// Appends to `text` how two pictures differ. Returns whether that passes.
bool compare(const Picture &a, const Picture &b, const Settings &s, std::string &text) {
    for (const Picture *p : {&a, &b})
        common::need(p->others.empty(),
                     "a picture has the channels" + p->others + ", which are not all compared");
    common::need(a.light.empty() == b.light.empty(),
                 "one picture has floats, which are linear, and the other has not");
    common::need(a.width == b.width && a.height == b.height,
                 common::format("the sizes differ: %dx%d and %dx%d", a.width, a.height, b.width, b.height));
    Difference d = between(a, b);
    double db = psnr(d.squares, d.values);
    common::append(text, "psnr %.2f dB, largest difference %.4g, %zu of %zu pixels differ", db, d.largest,
                   d.pixels, a.pixels());
    if (d.values > 3 * a.pixels()) common::append(text, ", %zu in alpha", d.transparent);
    std::string kindA = kindOf(a), kindB = kindOf(b);
    text += kindA == kindB ? "\n" : "\nA has " + kindA + ", B has " + kindB + "\n";
    // What both say alike makes no difference
    std::map<std::string, uint64_t> unlike;
    std::set_symmetric_difference(a.unused.begin(), a.unused.end(), b.unused.begin(), b.unused.end(),
                                  std::inserter(unlike, unlike.end()));
    for (const auto &[what, hash] : unlike) text += "not compared, and not alike: " + what + "\n";
    if (s.seen) {
        Image imageA = toImage(a), imageB = toImage(b);
        common::append(text, "mean flip %.4f, psnr in linear light %.2f dB, in sRGB %.2f dB\n",
                       meanFlip(see(imageA.rgb, a.width, a.height), see(imageB.rgb, b.width, b.height)),
                       linearPsnr(imageA.rgb, imageB.rgb), psnr(imageA.rgb, imageB.rgb));
    }
    if (!s.diff.empty()) writePng(s.diff, d.enlarged);
    return unlike.empty() && (d.largest <= s.most || (s.leastPsnr != HUGE_VAL && db >= s.leastPsnr));
}

size_t countRest(PictureFile &file) {
    size_t count = 0;
    for (; file.more(); ++count) file.next();
    return count;
}

int compareFiles(const std::string &pathA, const std::string &pathB, const Settings &s) {
    PictureFile a(pathA), b(pathB);
    bool pass = true, several = false;
    size_t count = 0;
    std::string text; // printed if all can be compared
    do {
        Picture one = a.next(), other = b.next();
        several |= a.more() || b.more();
        ++count;
        if (several) {
            common::need(s.diff.empty(), "--diff is for files of one picture");
            common::append(text, "picture %zu: ", count);
        }
        pass &= compare(one, other, s, text);
    } while (a.more() && b.more());
    if (a.more() || b.more()) {
        size_t countA = count + countRest(a), countB = count + countRest(b);
        throw common::Refused(common::format("the numbers of pictures differ: %zu and %zu", countA, countB));
    }
    std::fputs(text.c_str(), stdout);
    return pass ? 0 : 1;
}

int run(common::CommandLine &line) {
    std::string pathA, pathB;
    Settings s;
    bool toPng = false, toLinear = false;
    int by = 1;
    line.about(
        "Prints the PSNR of two pictures, the largest difference of a channel (in steps of 1/255) and the\n"
        "number of pixels that differ; then what their files hold, if that differs: bits, alpha. A picture\n"
        "without alpha is opaque. Floats are linear, and 1 is 255. Of files with several pictures all are\n"
        "compared, in order. What files say of their numbers and is not used (gamma, profiles, orientation,\n"
        "animations) must be alike. Exit status 1: it is not, or a largest difference is over --max and the\n"
        "PSNR is under --psnr (if given).");
    line.argument("A", pathA, "a picture: PNG, JPEG, TGA, BMP, PNM, Radiance HDR or OpenEXR");
    line.argument("B", pathB, "another; with --png or --linear the file to write");
    line.option("--max", "N", s.most, {0, 255}, "the largest difference of a channel that passes");
    line.option("--psnr", "DB", s.leastPsnr, {0, 1000}, "the PSNR from which pictures pass in any case");
    line.option("--diff", "OUT.png", s.diff, "write the differences, times eight; those in alpha are grey");
    line.flag(
        "--seen", s.seen,
        "also print what a viewer sees: mean FLIP at 67 pixels per degree, PSNR in linear light and in sRGB");
    line.flag("--png", toPng, "instead, write the picture A as PNG of eight bits, without alpha, to B");
    line.flag("--linear", toLinear, "instead, read A as linear numbers, and write it as sRGB to B");
    line.option("--by", "N", by, {1, 16}, "with --linear: average squares of N x N pixels");
    line.parse();

    if (!s.diff.empty()) common::claimOutput(s.diff);
    if (!toPng && !toLinear) return compareFiles(pathA, pathB, s);
    common::claimOutput(pathB);
    Picture a = readPicture(pathA);
    for (const auto &[what, hash] : a.unused)
        std::fprintf(stderr, "compare: %s: %s is not used\n", pathA.c_str(), what.c_str());
    writePng(pathB, toLinear ? common::inFile(pathA, [&] { return linearToImage(a, by); }) : toImage(a));
    return 0;
}

} // namespace

} // namespace pictures

int main(int argc, char **argv) { return common::runProgram("compare", argc, argv, pictures::run); }

// compare: measures the difference of two pictures.
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
    double squares = 0, largest = 0; // sum of squares and largest difference of a channel, in steps of 1/255
    size_t values = 0;               // number of compared values: pixels times channels
    size_t pixels = 0;               // number of pixels that differ
    size_t pixelsInAlpha = 0;        // number of pixels that differ in alpha
    Image amplified;                 // the differences, times eight
};

Difference differenceOf(const Picture &a, const Picture &b) {
    Difference all;
    size_t channels = a.hasAlpha() || b.hasAlpha() ? 4 : 3;
    all.values = a.pixels() * channels;
    all.amplified = {a.width, a.height, std::vector<uint8_t>(a.pixels() * 3)};
    for (size_t i = 0; i < a.pixels(); ++i) {
        auto stepsA = a.steps(i), stepsB = b.steps(i);
        double d[4] = {};
        for (size_t c = 0; c < channels; ++c) {
            d[c] = std::fabs(stepsA[c] - stepsB[c]);
            all.squares += d[c] * d[c];
            all.largest = std::max(all.largest, d[c]);
        }
        all.pixels += d[0] + d[1] + d[2] + d[3] > 0;
        all.pixelsInAlpha += d[3] > 0;
        for (size_t c = 0; c < 3; ++c)
            all.amplified.rgb[i * 3 + c] = (uint8_t)std::min(255., 8 * std::max(d[c], d[3]) + 0.5);
    }
    return all;
}

std::string formatOf(const Picture &p) {
    return common::format(p.light.empty() ? "%d bits" : "floats of %d bits", p.bits) +
           (p.hasAlpha() ? " and alpha" : "");
}

struct CompareSettings {
    double most = 0, leastPsnr = HUGE_VAL; // limits: the largest difference, or the least PSNR
    bool seen = false;
    std::string diff; // the file for the difference; may be empty
};

// Appends the differences of two pictures to `text`. Returns whether they are within the limits.
bool compare(const Picture &a, const Picture &b, const CompareSettings &s, std::string &text) {
    for (const Picture *p : {&a, &b})
        common::need(p->others.empty(), "cannot compare all channels of a picture, which are" + p->others);
    common::need(a.light.empty() == b.light.empty(),
                 "one picture has floats, which are linear, and the other has not");
    common::need(a.width == b.width && a.height == b.height,
                 common::format("the sizes differ: %dx%d and %dx%d", a.width, a.height, b.width, b.height));
    Difference d = differenceOf(a, b);
    double db = psnr(d.squares, d.values);
    common::append(text, "psnr %.2f dB, largest difference %.4g, %zu of %zu %s", db, d.largest, d.pixels,
                   a.pixels(), a.pixels() == 1 ? "pixel differs" : "pixels differ");
    if (d.values > 3 * a.pixels()) common::append(text, ", %zu in alpha", d.pixelsInAlpha);
    std::string formatA = formatOf(a), formatB = formatOf(b);
    text += formatA == formatB ? "\n" : "\nA has " + formatA + ", B has " + formatB + "\n";
    // Unused statements about the pixels count only if they differ
    std::map<std::string, uint64_t> unlike;
    std::set_symmetric_difference(a.unused.begin(), a.unused.end(), b.unused.begin(), b.unused.end(),
                                  std::inserter(unlike, unlike.end()));
    for (const auto &[what, hash] : unlike) text += "not compared, and different: " + what + "\n";
    if (s.seen) {
        Image imageA = toImage(a), imageB = toImage(b);
        common::append(text, "mean flip %.4f, psnr in linear light %.2f dB, in sRGB %.2f dB\n",
                       meanFlip(see(imageA.rgb, a.width, a.height), see(imageB.rgb, b.width, b.height)),
                       linearPsnr(imageA.rgb, imageB.rgb), psnr(imageA.rgb, imageB.rgb));
    }
    if (!s.diff.empty()) writePng(s.diff, d.amplified);
    bool asksPsnr = s.leastPsnr != HUGE_VAL, within = d.largest <= s.most || (asksPsnr && db >= s.leastPsnr);
    if (!within) common::append(text, "fails: the largest difference %.4g is above %g", d.largest, s.most);
    if (!within && asksPsnr) // rounded down, since 44.999 is below 45
        common::append(text, ", and %.2f dB is below %g", std::floor(db * 100) / 100, s.leastPsnr);
    if (!within) text += "\n";
    return within && unlike.empty();
}

size_t countRest(PictureFile &file) {
    size_t count = 0;
    for (; file.more(); ++count) file.next();
    return count;
}

int compareFiles(const std::string &pathA, const std::string &pathB, const CompareSettings &s) {
    PictureFile a(pathA), b(pathB);
    bool pass = true, several = false;
    size_t count = 0;
    std::string text; // printed only if all pictures can be compared
    do {
        Picture one = a.next(), other = b.next();
        several |= a.more() || b.more();
        ++count;
        if (several) {
            common::need(s.diff.empty(), "--diff needs files with a single picture");
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
    CompareSettings s;
    bool toPng = false, toLinear = false;
    int by = 1;
    line.about(
        "Prints the PSNR of two pictures, the largest difference of a channel (in steps of 1/255) and the\n"
        "number of pixels that differ. Also prints their numbers of bits and alpha, if these differ. A "
        "picture\n"
        "without alpha is opaque. Floats are linear, and 1 is 255. Files with several pictures are compared\n"
        "picture by picture. Statements in the files that are not used (gamma, profiles, orientation,\n"
        "animations) must be equal. The exit status is 1 if they are not, or if the largest difference is "
        "above\n"
        "--max and the PSNR is below --psnr (if given).");
    line.argument("A", pathA, "a picture: PNG, JPEG, TGA, BMP, PNM, Radiance HDR or OpenEXR");
    line.argument("B", pathB, "another picture; with --png or --linear, the file to write");
    line.option("--max", "N", s.most, {0, 255}, "the largest difference of a channel that passes");
    line.option("--psnr", "DB", s.leastPsnr, {0, 1000}, "the least PSNR that passes, whatever --max is");
    line.option("--diff", "OUT.png", s.diff, "write the differences, times eight; those in alpha are grey");
    line.flag(
        "--seen", s.seen,
        "also print the visible difference: mean FLIP at 67 pixels per degree, PSNR in linear light and in "
        "sRGB");
    line.flag("--png", toPng, "write picture A to B instead, as PNG of eight bits without alpha");
    line.flag("--linear", toLinear, "write picture A to B instead: read it as linear light, write sRGB");
    line.option("--by", "N", by, {1, 16}, "with --linear: average squares of N x N pixels");
    line.parse();

    if (!s.diff.empty()) common::claimOutput(s.diff);
    formatNamed(s.diff); // refuses other formats
    if (!toPng && !toLinear) return compareFiles(pathA, pathB, s);
    common::claimOutput(pathB);
    formatNamed(pathB);
    Picture a = readPicture(pathA);
    for (const auto &[what, hash] : a.unused)
        std::fprintf(stderr, "compare: %s: %s is not used\n", pathA.c_str(), what.c_str());
    writePng(pathB, toLinear ? common::inFile(pathA, [&] { return linearToImage(a, by); }) : toImage(a));
    return 0;
}

} // namespace

} // namespace pictures

int main(int argc, char **argv) { return common::runProgram("compare", argc, argv, pictures::run); }

// compare: measures how much two pictures differ.
#include "tools/common/command_line.h"
#include "tools/common/text.h"
#include "tools/picture/flip.h"
#include "tools/picture/picture.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pictures {

namespace {

struct Difference {
    double squares = 0; // sum over all channels
    int largest = 0;    // of one channel
    size_t pixels = 0;  // pixels that differ
    Image enlarged;     // eight times
};

Difference between(const Image &a, const Image &b) {
    Difference all;
    all.enlarged = a;
    for (size_t i = 0; i < a.rgb.size(); i += 3) {
        bool differs = false;
        for (size_t c = i; c < i + 3; ++c) {
            int d = std::abs(a.rgb[c] - b.rgb[c]);
            all.squares += d * d;
            all.largest = std::max(all.largest, d);
            differs |= d != 0;
            all.enlarged.rgb[c] = (uint8_t)std::min(255, 8 * d);
        }
        all.pixels += differs;
    }
    return all;
}

int run(common::CommandLine &line) {
    std::string pathA, pathB, diff;
    bool toPng = false, toLinear = false, seen = false;
    int by = 1;
    double most = 0, leastPsnr = HUGE_VAL;
    line.about(
        "Prints the PSNR of two pictures, the largest difference of a channel (0..255) and the number of\n"
        "pixels that differ. Exit status 1: the largest difference is over --max and the PSNR is under\n"
        "--psnr (if given).");
    line.argument("A", pathA, "a picture: PNG, PPM, JPEG, TGA or BMP");
    line.argument("B", pathB, "another; with --png or --linear the file to write");
    line.option("--max", "N", most, {0, 255}, "the largest difference of a channel that passes");
    line.option("--psnr", "DB", leastPsnr, {0, 1000}, "the PSNR from which pictures pass in any case");
    line.option("--diff", "OUT.png", diff, "write the differences, times eight");
    line.flag(
        "--seen", seen,
        "also print what a viewer sees: mean FLIP at 67 pixels per degree, PSNR in linear light and in sRGB");
    line.flag("--png", toPng, "instead, write the picture A as PNG to B");
    line.flag("--linear", toLinear,
              "instead, read A as a PNG of 16 bits that are linear, and write it as sRGB to B");
    line.option("--by", "N", by, {1, 16}, "with --linear: average squares of N x N pixels");
    line.parse();

    Image a = toLinear ? readLinear(pathA, by) : readPicture(pathA);
    if (toPng || toLinear) {
        writePng(pathB, a);
        return 0;
    }
    Image b = readPicture(pathB);
    if (a.width != b.width || a.height != b.height)
        throw common::Refused(
            common::format("the sizes differ: %dx%d and %dx%d", a.width, a.height, b.width, b.height));
    Difference d = between(a, b);
    double db = psnr(d.squares, a.rgb.size());
    std::printf("psnr %.2f dB, largest difference %d, %zu of %zu pixels differ\n", db, d.largest, d.pixels,
                a.rgb.size() / 3);
    if (seen)
        std::printf("mean flip %.4f, psnr in linear light %.2f dB, in sRGB %.2f dB\n",
                    meanFlip(see(a.rgb, a.width, a.height), see(b.rgb, b.width, b.height)),
                    linearPsnr(a.rgb, b.rgb), db);
    if (!diff.empty()) writePng(diff, d.enlarged);
    bool differ = d.largest > most, far = leastPsnr == HUGE_VAL || db < leastPsnr;
    return differ && far ? 1 : 0;
}

} // namespace

} // namespace pictures

int main(int argc, char **argv) { return common::runProgram("compare", argc, argv, pictures::run); }

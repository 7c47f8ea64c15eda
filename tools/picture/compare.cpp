// compare: measures how much two pictures differ.
#include "tools/common/arguments.h"
#include "tools/common/statistics.h"
#include "tools/measure/detect/flip.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: compare A B [--max N=0] [--psnr DB] [--diff OUT.png] [--seen]\n"
    "       compare --png IN OUT.png\n"
    "       compare --linear IN OUT.png [--by N=1]\n"
    "A and B are PNG or PPM. Prints the PSNR, the largest difference of a channel (0..255) and the number of "
    "pixels\n"
    "that differ. Exit 1 when the largest difference is over --max and the PSNR is under --psnr (if given); "
    "--diff\n"
    "writes the differences, times eight. --seen tells how B differs from A to the eye: mean FLIP "
    "at 67\n"
    "pixels per degree, PSNR in linear light and in sRGB. --png writes the picture IN as PNG; --linear does "
    "so with\n"
    "one of 16 bits that are linear, averaging N x N pixels.\n";

static Picture read(const std::string &path) {
    Picture p;
    if (!readPicture(path, p)) throw Refused("cannot read a picture from " + path);
    return p;
}

static void write(const std::string &path, const Picture &p) {
    if (!writePng(path, p)) throw Refused("cannot write " + path);
}

struct Difference {
    double squares = 0; // sum over all channels
    int largest = 0;    // of one channel
    size_t pixels = 0;  // pixels that differ
    Picture enlarged;   // eight times
};

static Difference between(const Picture &a, const Picture &b) {
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

static int run(Arguments &words) {
    std::vector<std::string> paths;
    std::string diff;
    bool convert = false, linear = false, seen = false;
    int by = 1;
    double most = 0, leastPsnr = HUGE_VAL;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--max")
            most = words.number(w, 0, 255);
        else if (w == "--psnr")
            leastPsnr = words.number(w, 0, 1000);
        else if (w == "--diff")
            diff = words.value(w);
        else if (w == "--png")
            convert = true;
        else if (w == "--linear")
            linear = true;
        else if (w == "--by")
            by = words.whole(w, 1, 16);
        else if (w == "--seen")
            seen = true;
        else if (word[0] != '-' && paths.size() < 2)
            paths.push_back(w);
        else
            words.refuse(w);
    }
    if (paths.size() < 2) throw Refused("two pictures are needed; see compare --help");
    Picture a;
    if (!linear)
        a = read(paths[0]);
    else if (!readLinear(paths[0], by, a))
        throw Refused("cannot read a picture that " + std::to_string(by) + " divides from " + paths[0]);
    if (convert || linear) {
        write(paths[1], a);
        return 0;
    }
    Picture b = read(paths[1]);
    if (a.width != b.width || a.height != b.height)
        throw Refused("the sizes differ: " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                      " and " + std::to_string(b.width) + "x" + std::to_string(b.height));
    Difference d = between(a, b);
    double db = psnr(d.squares, a.rgb.size());
    std::printf("psnr %.2f dB, largest difference %d, %zu of %zu pixels differ\n", db, d.largest, d.pixels,
                a.rgb.size() / 3);
    if (seen)
        std::printf("mean flip %.4f, psnr in linear light %.2f dB, in sRGB %.2f dB\n",
                    meanFlip(see(a.rgb, a.width, a.height), see(b.rgb, b.width, b.height)),
                    linearPsnr(a.rgb, b.rgb), db);
    if (!diff.empty()) write(diff, d.enlarged);
    bool differ = d.largest > most, far = leastPsnr == HUGE_VAL || db < leastPsnr;
    return differ && far ? 1 : 0;
}

int main(int argc, char **argv) { return runProgram("compare", kUsage, argc, argv, run); }

// compare: how far two pictures are apart.
#include "tools/common/arguments.h"
#include "tools/common/statistics.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: compare A B [--max N=0] [--psnr DB] [--diff OUT.png]\n"
    "       compare --png IN OUT.png\n"
    "A and B are PNG or PPM. Prints the PSNR, the largest difference of a channel (0..255) and the number of "
    "pixels\n"
    "that differ. Exit 1 when the largest difference is over --max and the PSNR is under --psnr (if given); "
    "--diff\n"
    "writes the differences, eight times enlarged. --png writes the picture IN as PNG.\n";

static Picture read(const std::string &path) {
    Picture p;
    if (!readPicture(path, p)) throw Refused("cannot read a picture from " + path);
    return p;
}

static void write(const std::string &path, const Picture &p) {
    if (!writePng(path, p)) throw Refused("cannot write " + path);
}

struct Difference {
    double squares = 0; // of all channels, in sum
    int largest = 0;    // of a channel
    size_t pixels = 0;  // that differ
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
    bool convert = false;
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
        else if (word[0] != '-' && paths.size() < 2)
            paths.push_back(w);
        else
            words.refuse(w);
    }
    if (paths.size() < 2) throw Refused("two pictures are needed; see compare --help");
    Picture a = read(paths[0]);
    if (convert) {
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
    if (!diff.empty()) write(diff, d.enlarged);
    bool differ = d.largest > most, far = leastPsnr == HUGE_VAL || db < leastPsnr;
    return differ && far ? 1 : 0;
}

int main(int argc, char **argv) { return runProgram("compare", kUsage, argc, argv, run); }

// compare: how far two pictures are apart.
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

static constexpr char kUsage[] =
    "usage: compare A B [--max N=0] [--psnr DB] [--diff OUT.png]\n"
    "       compare --png IN OUT.png\n"
    "A and B are PNG or PPM. Prints the PSNR, the largest difference of a channel (0..255) and the number of "
    "pixels\n"
    "that differ. Exit 1 when the largest difference is over --max and the PSNR is under --psnr (if given); "
    "--diff\n"
    "writes the differences, eight times enlarged. --png writes the picture IN as PNG.";

static int refuse(const std::string &line) {
    std::fprintf(stderr, "compare: %s\n", line.c_str());
    return 2;
}

int main(int argc, char **argv) {
    const char *paths[2] = {}, *diff = nullptr;
    int given = 0;
    long most = 0;
    double leastPsnr = HUGE_VAL;
    if (argc == 4 && !std::strcmp(argv[1], "--png")) {
        Picture p;
        if (!readPicture(argv[2], p)) return refuse(std::string("cannot read a picture from ") + argv[2]);
        return writePng(argv[3], p) ? 0 : refuse(std::string("cannot write ") + argv[3]);
    }
    for (int i = 1; i < argc; ++i) {
        auto number = [&](double &value) {
            char *end;
            value = std::strtod(argv[++i], &end);
            return end != argv[i] && !*end && value >= 0;
        };
        double value;
        if (!std::strcmp(argv[i], "--help")) return std::printf("%s\n", kUsage), 0;
        if (!std::strcmp(argv[i], "--max") && i + 1 < argc) {
            if (!number(value)) return refuse(std::string("--max needs a number, not '") + argv[i] + "'");
            most = (long)value;
        } else if (!std::strcmp(argv[i], "--psnr") && i + 1 < argc) {
            if (!number(leastPsnr))
                return refuse(std::string("--psnr needs a number, not '") + argv[i] + "'");
        } else if (!std::strcmp(argv[i], "--diff") && i + 1 < argc)
            diff = argv[++i];
        else if (argv[i][0] != '-' && given < 2)
            paths[given++] = argv[i];
        else
            return refuse(std::string("cannot use '") + argv[i] + "'; see compare --help");
    }
    if (given != 2) return refuse("two pictures are needed; see compare --help");

    Picture a, b;
    if (!readPicture(paths[0], a)) return refuse(std::string("cannot read a picture from ") + paths[0]);
    if (!readPicture(paths[1], b)) return refuse(std::string("cannot read a picture from ") + paths[1]);
    if (a.width != b.width || a.height != b.height)
        return refuse("the sizes differ: " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                      " and " + std::to_string(b.width) + "x" + std::to_string(b.height));
    double squares = 0;
    int largest = 0;
    size_t pixels = 0;
    Picture difference = a;
    for (size_t i = 0; i < a.rgb.size(); i += 3) {
        bool differs = false;
        for (size_t c = i; c < i + 3; ++c) {
            int d = std::abs(a.rgb[c] - b.rgb[c]);
            squares += d * d;
            largest = std::max(largest, d);
            differs |= d != 0;
            difference.rgb[c] = (uint8_t)std::min(255, 8 * d);
        }
        pixels += differs;
    }
    double psnr = squares > 0 ? 10 * std::log10(255. * 255. * (double)a.rgb.size() / squares) : HUGE_VAL;
    std::printf("psnr %.2f dB, largest difference %d, %zu of %zu pixels differ\n", psnr, largest, pixels,
                a.rgb.size() / 3);
    if (diff && !writePng(diff, difference)) return refuse(std::string("cannot write ") + diff);
    bool tooFar = leastPsnr < HUGE_VAL ? psnr < leastPsnr && largest > most : largest > most;
    return tooFar ? 1 : 0;
}

#include "tools/picture/readers.h"

#include "tools/common/command_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <sstream>
#include <vector>

namespace pictures {

namespace {

// Radiance stores CIE XYZ in lumens, and red, green and blue in watts.
constexpr double kLumensOfWatt = 179;
constexpr double kMostOfFloat = 3e38;

class HdrReader {
public:
    explicit HdrReader(std::string_view file) : file(file) {}

    Picture read() {
        readHead();
        readOrder();
        line.resize((size_t)perLine * 4);
        for (int i = 0; i < lines; ++i) {
            // Memory grows with the data that is read, not with the size in the header
            readLine();
            for (int j = 0; j < perLine; ++j) addPixel(&line[(size_t)j * 4]);
        }
        if (first == 'X' || !firstForward || !secondForward) picture.light = inOrder();
        return std::move(picture);
    }
    std::string_view rest() const { return file.substr(at); }

private:
    std::string_view file;
    Picture picture = {.bits = 32};
    size_t at = 0;
    bool xyz = false;
    std::array<double, 3> multiplied = {1, 1, 1};   // the factors by which pixels were multiplied
    char first = 0, second = 0;                     // the axis from line to line, and the axis along a line
    bool firstForward = true, secondForward = true; // whether the axes point down or right
    int lines = 0, perLine = 0;
    std::vector<uint8_t> line;

    [[noreturn]] static void refuse(const std::string &what) { throw common::Refused(what); }

    // Reads a line of the header, which ends with LF or CR LF.
    std::string text() {
        size_t end = file.find('\n', at);
        if (end == file.npos) refuse("it ends within its header");
        std::string line(file.substr(at, end - at));
        if (line.ends_with('\r')) line.pop_back();
        at = end + 1;
        return line;
    }

    // Reads the lines of text up to an empty line.
    void readHead() {
        for (std::string line = text(); !line.empty(); line = text())
            if (line.starts_with("FORMAT="))
                readFormat(line.substr(7));
            else if (line.starts_with("EXPOSURE="))
                readFactors(line, 1);
            else if (line.starts_with("COLORCORR="))
                readFactors(line, 3);
            else
                readOther(line);
    }

    // Notes a line that changes the light, unless its values are usual (sRGB's, or Radiance's defaults).
    void readOther(const std::string &line) {
        static const std::map<std::string, std::vector<double>> kUsual = {
            {"PRIMARIES", {.64, .33, .295, .6, .15, .06, .323, .331}}, {"GAMMA", {1}}, {"PIXASPECT", {1}}};
        const size_t end = line.find('=');
        auto known = kUsual.find(line.substr(0, end));
        if (known == kUsual.end()) return;
        std::istringstream values(line.substr(end + 1));
        double got;
        for (double x : known->second)
            if (!(values >> got) || std::fabs(got - x) > 0.011) return picture.leave(known->first, line);
    }

    void readFormat(std::string format) {
        format.erase(format.find_last_not_of(" \t") + 1);
        format.erase(0, format.find_first_not_of(' '));
        xyz = format == "32-bit_rle_xyze";
        if (!xyz && format != "32-bit_rle_rgbe")
            refuse("its pixels have the format " + format +
                   "; only 32-bit_rle_rgbe and 32-bit_rle_xyze are read");
    }

    // Reads a line of factors. If a line is repeated, all factors count.
    void readFactors(const std::string &text, int count) {
        double f[3];
        int got = std::sscanf(text.c_str() + text.find('=') + 1, "%lf %lf %lf", f, f + 1, f + 2);
        if (count == 1) f[1] = f[2] = f[0];
        for (size_t k = 0; k < 3; ++k) {
            if (got >= count && f[k] != 0) multiplied[k] *= f[k];
            if (got < count || !(multiplied[k] > 1e-18 && multiplied[k] < 1e18))
                refuse("it has a damaged line " + text);
        }
    }

    // Reads the line with size and order of the pixels: usually -Y HEIGHT +X WIDTH, which is lines from top
    // to bottom, each from left to right.
    void readOrder() {
        char signs[2];
        if (std::sscanf(text().c_str(), "%c%c %d %c%c %d", signs, &first, &lines, signs + 1, &second,
                        &perLine) != 6 ||
            !((first == 'X' && second == 'Y') || (first == 'Y' && second == 'X')) ||
            !std::strchr("+-", signs[0]) || !std::strchr("+-", signs[1]))
            refuse("it has no line like -Y HEIGHT +X WIDTH before its pixels");
        if (lines < 1 || perLine < 1 || (int64_t)lines * perLine > kMostPixels)
            refuse("it has no pixels, or more than 2^27");
        firstForward = (signs[0] == '+') == (first == 'X'),
        secondForward = (signs[1] == '+') == (second == 'X');
        picture.width = first == 'X' ? lines : perLine, picture.height = first == 'X' ? perLine : lines;
    }

    uint8_t next() {
        if (at >= file.size()) refuse("it ends before its last pixel");
        return (uint8_t)file[at++];
    }

    void readLine() {
        for (size_t k = 0; k < 4; ++k) line[k] = next();
        if (perLine >= 8 && perLine < 32768 && line[0] == 2 && line[1] == 2 &&
            line[2] * 256 + line[3] == perLine)
            readPlanes();
        else
            readPixels();
    }

    void readPlanes() {
        for (size_t k = 0; k < 4; ++k)
            for (int i = 0; i < perLine;) {
                int count = next(), run = count > 128;
                if (run) count -= 128;
                if (count == 0 || i + count > perLine) refuse("it is damaged: a run is longer than its row");
                uint8_t value = run ? next() : 0;
                for (; count; --count, ++i) line[(size_t)i * 4 + k] = run ? value : next();
            }
    }

    // Reads plain pixels, and runs of the older kind: 1, 1, 1, N repeats the last pixel N times. Another such
    // pixel directly after it has the next higher byte of N.
    void readPixels() {
        int shift = 0;
        for (int i = 0; i < perLine;) {
            uint8_t *p = &line[(size_t)i * 4];
            if (i || shift)
                for (size_t k = 0; k < 4; ++k) p[k] = next();
            if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
                ++i, shift = 0;
                continue;
            }
            if (i == 0) refuse("it is damaged: a row begins with a run");
            uint64_t count = shift < 32 ? (uint64_t)p[3] << shift : p[3] ? UINT32_MAX : 0;
            if (count > (uint64_t)(perLine - i)) refuse("it is damaged: a run is longer than its row");
            for (; count; --count, ++i, p += 4) std::memcpy(p, p - 4, 4);
            shift += 8;
        }
    }

    void addPixel(const uint8_t *p) {
        const double scale = p[3] ? std::ldexp(1., p[3] - 136) / (xyz ? kLumensOfWatt : 1) : 0;
        std::array<double, 3> c;
        for (size_t k = 0; k < 3; ++k) c[k] = p[k] * scale / multiplied[k];
        if (xyz) c = rgbOfXyz(c);
        // Clamp colours outside the gamut, which are below 0
        for (double light : c) picture.light.push_back((float)std::clamp(light, 0., kMostOfFloat));
    }

    // Sorts the pixels into rows from top to bottom, each from left to right.
    std::vector<float> inOrder() const {
        std::vector<float> to(picture.light.size());
        const float *from = picture.light.data();
        for (int i = 0; i < lines; ++i)
            for (int j = 0; j < perLine; ++j, from += 3) {
                int a = firstForward ? i : lines - 1 - i, b = secondForward ? j : perLine - 1 - j;
                int x = first == 'X' ? a : b, y = first == 'X' ? b : a;
                std::copy_n(from, 3, &to[((size_t)y * (size_t)picture.width + (size_t)x) * 3]);
            }
        return to;
    }
};

} // namespace

Picture takeHdr(std::string_view &file) {
    HdrReader reader(file);
    Picture p = reader.read();
    file = isHdr(reader.rest()) ? reader.rest() : std::string_view();
    return p;
}

} // namespace pictures

#include "tools/radiosity/read/hdr_reader.h"

#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace odraz {

HdrPicture readHdr(const std::string &path) {
    std::string file = readWhole(path);
    HdrPicture picture = {};
    int &width = picture.width, &height = picture.height;
    auto refuse = [&](const char *what) { throw Refused(path + ": " + what); };
    size_t at = file.find("\n\n");
    int read = 0;
    if (file.compare(0, 2, "#?") || at == std::string::npos ||
        std::sscanf(file.c_str() + at + 2, "-Y %d +X %d%n", &height, &width, &read) != 2 || !read)
        refuse("is not a picture in Radiance's HDR format with rows from the top (-Y) and the left (+X)");
    if (width < 1 || height < 1 || (int64_t)width * height > 1 << 27)
        refuse("has no pixels, or more than 2^27");
    at += 3 + (size_t)read;
    auto next = [&] {
        if (at >= file.size()) refuse("ends before its last pixel");
        return (uint8_t)file[at++];
    };
    std::vector<uint8_t> row((size_t)width * 4);
    for (int j = 0; j < height; ++j) {
        for (size_t k = 0; k < 4; ++k) row[k] = next();
        if (width >= 8 && width < 32768 && row[0] == 2 && row[1] == 2 && row[2] * 256 + row[3] == width) {
            for (size_t k = 0; k < 4; ++k)
                for (int i = 0; i < width;) {
                    int count = next(), run = count > 128;
                    if (run) count -= 128;
                    if (count == 0 || i + count > width) refuse("is damaged: a run is longer than its row");
                    uint8_t value = run ? next() : 0;
                    for (; count; --count, ++i) row[(size_t)i * 4 + k] = run ? value : next();
                }
        } else {
            for (size_t k = 4; k < row.size(); ++k) row[k] = next();
        }
        for (size_t i = 0; i < (size_t)width; ++i) {
            const uint8_t *p = &row[i * 4];
            for (size_t k = 0; k < 3; ++k)
                picture.pixels.push_back(p[3] ? std::ldexp((float)p[k], p[3] - 136) : 0);
        }
    }
    return picture;
}

} // namespace odraz

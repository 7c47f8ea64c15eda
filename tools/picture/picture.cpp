#include "tools/picture/picture.h"

#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cmath>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_HDR
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace pictures {

Image readPicture(const std::string &path) {
    Image p;
    int channels;
    uint8_t *data = stbi_load(path.c_str(), &p.width, &p.height, &channels, 3);
    if (!data) throw common::Refused("cannot read a picture from " + path);
    p.rgb.assign(data, data + (size_t)p.width * (size_t)p.height * 3);
    stbi_image_free(data);
    return p;
}

Image readLinear(const std::string &path, int by) {
    int width, height, channels;
    std::unique_ptr<uint16_t, void (*)(void *)> data(
        stbi_load_16(path.c_str(), &width, &height, &channels, 3), stbi_image_free);
    if (!data || width % by || height % by)
        throw common::Refused("cannot read a picture that " + std::to_string(by) + " divides from " + path);
    Image p = {width / by, height / by, {}};
    p.rgb.resize((size_t)p.width * (size_t)p.height * 3);
    for (size_t i = 0; i < p.rgb.size(); ++i) {
        size_t c = i % 3, x = i / 3 % (size_t)p.width * (size_t)by, y = i / 3 / (size_t)p.width * (size_t)by;
        double sum = 0;
        for (size_t v = y; v < y + (size_t)by; ++v)
            for (size_t u = x; u < x + (size_t)by; ++u) sum += data.get()[(v * (size_t)width + u) * 3 + c];
        p.rgb[i] = (uint8_t)(srgbOfLinear((float)(sum / (65535. * by * by))) * 255 + 0.5f);
    }
    return p;
}

bool readPpm(std::FILE *stream, Image &p) {
    int most;
    if (std::fscanf(stream, "P6 %d %d %d", &p.width, &p.height, &most) != 3 || most != 255 ||
        std::fgetc(stream) == EOF)
        return false;
    if (p.width < 1 || p.height < 1 || p.width > 32768 || p.height > 32768) return false;
    p.rgb.resize((size_t)p.width * (size_t)p.height * 3);
    return std::fread(p.rgb.data(), 1, p.rgb.size(), stream) == p.rgb.size();
}

void writePng(const std::string &path, const Image &p) {
    stbi_write_png_compression_level = 9;
    std::string png;
    auto append = [](void *to, void *bytes, int size) {
        ((std::string *)to)->append((const char *)bytes, (size_t)size);
    };
    if (!stbi_write_png_to_func(append, &png, p.width, p.height, 3, p.rgb.data(), p.width * 3))
        throw std::runtime_error("there is not enough memory for " + path);
    common::writeWhole(path, png);
}

Image shrink(const Image &p, int width) {
    Image small;
    small.width = std::min(width, p.width);
    small.height = std::max(1, (int)((int64_t)p.height * small.width / p.width));
    small.rgb.resize((size_t)small.width * (size_t)small.height * 3);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            int x0 = x * p.width / small.width, x1 = std::max(x0 + 1, (x + 1) * p.width / small.width);
            int y0 = y * p.height / small.height, y1 = std::max(y0 + 1, (y + 1) * p.height / small.height);
            for (int c = 0; c < 3; ++c) {
                int sum = 0, area = (x1 - x0) * (y1 - y0);
                for (int v = y0; v < y1; ++v)
                    for (int u = x0; u < x1; ++u)
                        sum += p.rgb[((size_t)v * (size_t)p.width + (size_t)u) * 3 + (size_t)c];
                small.rgb[((size_t)y * (size_t)small.width + (size_t)x) * 3 + (size_t)c] =
                    (uint8_t)((sum + area / 2) / area);
            }
        }
    return small;
}

} // namespace pictures

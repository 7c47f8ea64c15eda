#include "tools/picture/picture.h"

#include "tools/common/command_line.h"
#include "tools/common/folders.h"
#include "tools/common/hash.h"
#include "tools/common/whole_file.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <filesystem>
#include <strings.h>

#include <tinyexr.h>
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <stb/stb_image_resize.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace pictures {

void Picture::leave(const std::string &name, std::string_view bytes) {
    uint64_t &hash = unused.try_emplace(name, common::kFnvStart).first->second;
    hash = common::fnv1a(bytes, hash);
}

void Picture::needUsual(const std::string &name) const {
    for (const auto &[what, hash] : unused)
        common::need(light.empty(),
                     name + ": " + what + " is not supported, and the light would be wrong without it");
}

std::array<double, 4> Picture::steps(size_t pixel) const {
    std::array<double, 4> all;
    for (size_t c = 0; c < 4; ++c) {
        size_t i = pixel * (size_t)channels + (c == 3 ? (size_t)channels - 1 : channels < 3 ? 0 : c);
        all[c] = c == 3 && !hasAlpha() ? 255 : light.empty() ? encoded[i] / 257. : (double)light[i] * 255;
    }
    return all;
}

std::array<float, 3> Picture::linear(size_t pixel) const {
    static const std::vector<float> linearOf = [] {
        std::vector<float> v(65536);
        for (size_t i = 0; i < v.size(); ++i) v[i] = (float)linearOfSrgb((double)i / 65535);
        return v;
    }();
    std::array<float, 3> all;
    for (size_t c = 0; c < 3; ++c) {
        size_t i = pixel * (size_t)channels + (channels < 3 ? 0 : c);
        all[c] = light.empty() ? linearOf[encoded[i]] : light[i];
    }
    return all;
}

std::array<double, 3> rgbOfXyz(const std::array<double, 3> &c) {
    const auto [x, y, z] = c;
    return {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
            0.0557 * x - 0.2040 * y + 1.0570 * z};
}

static uint8_t eightBits(double linear) { return (uint8_t)(srgbOfLinear((float)linear) * 255 + 0.5f); }

Image toImage(const Picture &p) {
    Image image = {p.width, p.height, std::vector<uint8_t>(p.pixels() * 3)};
    for (size_t i = 0; i < p.pixels(); ++i) {
        std::array<double, 4> encoded = p.steps(i);
        for (size_t c = 0; c < 3; ++c)
            image.rgb[i * 3 + c] =
                p.light.empty() ? (uint8_t)(encoded[c] + 0.5) : eightBits(encoded[c] / 255);
    }
    return image;
}

Image linearToImage(const Picture &p, int by) {
    common::need(p.width % by == 0 && p.height % by == 0,
                 "its width and height must be multiples of " + std::to_string(by));
    Image image = {p.width / by, p.height / by, {}};
    for (int y = 0; y < p.height; y += by)
        for (int x = 0; x < p.width; x += by) {
            double sum[3] = {};
            for (int v = y; v < y + by; ++v)
                for (int u = x; u < x + by; ++u) {
                    std::array<double, 4> s = p.steps((size_t)v * (size_t)p.width + (size_t)u);
                    for (size_t c = 0; c < 3; ++c) sum[c] += s[c];
                }
            for (double s : sum) image.rgb.push_back(eightBits(s / (255. * by * by)));
        }
    return image;
}

static void write(const std::string &path, const Image &p, Format format) {
    stbi_write_png_compression_level = 9;
    std::string file;
    auto append = [](void *to, void *bytes, int size) {
        ((std::string *)to)->append((const char *)bytes, (size_t)size);
    };
    if (!(format == Format::Png
              ? stbi_write_png_to_func(append, &file, p.width, p.height, 3, p.rgb.data(), p.width * 3)
              : stbi_write_jpg_to_func(append, &file, p.width, p.height, 3, p.rgb.data(), 84)))
        throw std::runtime_error("not enough memory for " + path);
    common::writeWhole(path, file);
}
void writePng(const std::string &path, const Image &p) { write(path, p, Format::Png); }
void writeImage(const std::string &path, const Image &p) { write(path, p, formatNamed(path, Format::Jpeg)); }

void writeExr(const std::string &path, int width, int height, const std::vector<float> &rgb) {
    common::TemporaryFolder folder;
    const std::string part = folder / "part.exr"; // tinyexr does not write whole files or none
    const char *error = nullptr;
    if (SaveEXR(rgb.data(), width, height, 3, 0, part.c_str(), &error) != TINYEXR_SUCCESS)
        throw std::runtime_error("cannot write " + path + ": " + (error ? error : "unknown error"));
    common::writeWhole(path, common::readWhole(part));
}

Format formatNamed(const std::string &path, Format other) {
    static constexpr const char *kEndings[] = {".png", ".jpg", ".exr"};
    const std::string ending = std::filesystem::path(path).extension();
    for (Format format : {Format::Png, other})
        if (ending.empty() || !strcasecmp(ending.c_str(), kEndings[(int)format])) return format;
    throw common::Refused(path + ": " + ending + " is not written: name a file .png" +
                          (other == Format::Png ? "" : std::string(" or ") + kEndings[(int)other]));
}

Image shrink(const Image &p, int width) {
    Image small;
    small.width = std::min(width, p.width);
    small.height = std::max(1, (int)((int64_t)p.height * small.width / p.width));
    small.rgb.resize((size_t)small.width * (size_t)small.height * 3);
    stbir_resize_uint8_generic(p.rgb.data(), p.width, p.height, 0, small.rgb.data(), small.width,
                               small.height, 0, 3, STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP,
                               STBIR_FILTER_BOX, STBIR_COLORSPACE_LINEAR, nullptr);
    return small;
}

} // namespace pictures

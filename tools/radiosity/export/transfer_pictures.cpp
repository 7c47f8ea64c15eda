#include "tools/radiosity/export/transfer_pictures.h"

#include "show/font.h"
#include "tools/common/statistics.h"
#include "tools/picture/picture.h"
#include "tools/picture/psnr.h"
#include "trace/picture/development.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace odraz::radiosity {

namespace {

constexpr int kBall = 96, kGap = 12, kLabel = 26; // pixels
constexpr float kLetters = 11;

// A picture of cells, with lines of text between them.
class Sheet {
public:
    Sheet(int width, int height) : p{width, height, {}}, text(width, height) {
        p.rgb.assign((size_t)width * (size_t)height * 3, 20);
    }
    void set(int x, int y, const float (&srgb)[3]) {
        for (size_t k = 0; k < 3; ++k)
            p.rgb[((size_t)y * (size_t)p.width + (size_t)x) * 3 + k] =
                (uint8_t)std::lround(255 * std::clamp(srgb[k], 0.f, 1.f));
    }
    void write(const char *line, int x, int y, Align align = Align::Left) {
        drawText(text.frame, line, (float)x, (float)y, kLetters, 0.12f, 0, align, {1, 1, 1}, 1);
    }
    void save(const std::string &path) {
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                float ink = std::clamp(text.at(0, x, y), 0.f, 1.f);
                for (size_t k = 0; k < 3; ++k) {
                    uint8_t &c = p.rgb[((size_t)y * (size_t)p.width + (size_t)x) * 3 + k];
                    c = (uint8_t)std::lround((float)c + ((float)230 - (float)c) * ink);
                }
            }
        pictures::writePng(path, p);
    }

private:
    pictures::Image p;
    HeapFrame text;
};

// Orange above 0, blue below, black at 0; 1 is brightest.
struct Signed {
    float srgb[3];
    explicit Signed(float x) {
        float much = pictures::srgbOfLinear(std::fabs(x));
        const float above[3] = {1, 0.62f, 0.18f}, below[3] = {0.25f, 0.55f, 1};
        for (int k = 0; k < 3; ++k) srgb[k] = much * (x > 0 ? above[k] : below[k]);
    }
};

void drawBall(Sheet &to, int left, int top, int function) {
    static constexpr float kSamples = 4;
    // From in front, a little above and to the right
    Vec3 ahead = normalize(Vec3{0.35f, 0.4f, 0.85f}), right = normalize(cross(Vec3{0, 1, 0}, ahead)),
         up = cross(ahead, right);
    float most = 0, radius = kBall / 2.f;
    auto valueAt = [&](const Vec3 &d) {
        Float8 y[kMostSh];
        evaluateBands(broadcast(d), kMostBands, y);
        return y[function][0];
    };
    for (int i = 0; i < kDirections; i += 8) {
        float solidAngle;
        Float8 y[kMostSh];
        evaluateBands(direction(i, solidAngle), kMostBands, y);
        for (int k = 0; k < 8; ++k) most = std::max(most, std::fabs(y[function][k]));
    }
    for (int j = 0; j < kBall; ++j)
        for (int i = 0; i < kBall; ++i) {
            float sum[3] = {0, 0, 0}, ground = 0;
            for (float b = 0.5f; b < kSamples; ++b)
                for (float a = 0.5f; a < kSamples; ++a) {
                    float x = ((float)i + a / kSamples) / radius - 1,
                          y = 1 - ((float)j + b / kSamples) / radius, square = 1 - x * x - y * y;
                    if (square <= 0) {
                        ++ground;
                        continue;
                    }
                    Signed shown(valueAt(right * x + up * y + ahead * std::sqrt(square)) / most);
                    for (int k = 0; k < 3; ++k) sum[k] += shown.srgb[k];
                }
            for (float &c : sum) c = (c + ground * 20 / 255) / (kSamples * kSamples);
            to.set(left + i, top + j, sum);
        }
}

void drawBasis(int bands, const std::string &path) {
    int across = 2 * bands - 1, step = kBall + kGap, aside = 60;
    Sheet sheet(aside + across * step + kGap, kGap + bands * (step + kLabel));
    for (int l = 0; l < bands; ++l) {
        int top = kGap + l * (step + kLabel);
        sheet.write(("band " + std::to_string(l)).c_str(), kGap, top + kBall / 2);
        for (int m = -l; m <= l; ++m) {
            int left = aside + kGap + (bands - 1 + m) * step;
            drawBall(sheet, left, top, l * (l + 1) + m);
            sheet.write((std::to_string(l) + ", " + std::to_string(m)).c_str(), left + kBall / 2,
                        top + kBall + 20, Align::Centre);
        }
    }
    sheet.save(path);
}

// The room's light from one range of bands, unclamped, without lamps.
std::vector<Rgb> seenBy(const TransferRoom &room, const Lighting &lighting, int first, int end,
                        const RenderSettings &camera, Workers &workers) {
    Lighting part = lighting;
    part.bands = end;
    std::fill(part.sky.begin(), part.sky.begin() + first * first, Rgb{});
    if (first > 0) part.lamps.assign(room.lamps.size(), 0.f);
    Solution model = room.model;
    Relighter(room).relight(part, model.light);
    lightLamps(room, part, model);
    return lookAt(model, camera, workers);
}

void drawBands(const TransferRoom &room, const Lighting &lighting, const RenderSettings &settings,
               Workers &workers, const std::string &path) {
    RenderSettings camera = settings;
    camera.width = std::max(settings.width / 4, 64), camera.height = std::max(settings.height / 4, 36);
    int bands = std::min(room.bands, lighting.bands), step = camera.width + kGap;
    Sheet sheet(bands * step + kGap, kGap + 2 * (camera.height + kLabel + kGap));
    std::vector<float> all;
    for (const Rgb &c : seenBy(room, lighting, 0, bands, camera, workers))
        if (float light = maxComponent(c); light > 0) all.push_back(light);
    float exposure = all.empty() ? 1 : std::exp2(settings.stops) * 0.5f / common::quantile(all, 0.6);
    HeapFrame shown(camera.width, camera.height);
    ToneCurve curve;
    makeToneCurve(curve);
    for (int l = 0; l < bands; ++l)
        for (int row = 0; row < 2; ++row) {
            int left = kGap + l * step, top = kGap + row * (camera.height + kLabel + kGap);
            std::vector<Rgb> seen = seenBy(room, lighting, row ? l : 0, l + 1, camera, workers);
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x) {
                    Rgb c = seen[(size_t)y * (size_t)camera.width + (size_t)x];
                    shown.at(0, x, y) = std::max(c.x, 0.f), shown.at(1, x, y) = std::max(c.y, 0.f),
                                   shown.at(2, x, y) = std::max(c.z, 0.f);
                    if (row) sheet.set(left + x, top + y, Signed((c.x + c.y + c.z) / 3 * exposure).srgb);
                }
            if (!row) {
                develop(curve, shown.frame, workers, exposure, 0);
                for (int y = 0; y < camera.height; ++y)
                    for (int x = 0; x < camera.width; ++x) {
                        const uint8_t *from = &shown.frame.rgba[(size_t)(y * camera.width + x) * 4];
                        sheet.set(left + x, top + y, {from[0] / 255.f, from[1] / 255.f, from[2] / 255.f});
                    }
            }
            std::string label = row ? "band " + std::to_string(l) + " alone"
                                : l ? "bands 0 to " + std::to_string(l)
                                    : "band 0";
            sheet.write(label.c_str(), left, top + camera.height + 20);
        }
    sheet.save(path);
}

} // namespace

void picturesOf(const TransferRoom &room, const Lighting &lighting, const RenderSettings &settings,
                Workers &workers, const std::string &folder) {
    std::error_code wrong;
    std::filesystem::create_directories(folder, wrong);
    if (wrong) throw std::runtime_error("cannot make the folder " + folder + ": " + wrong.message());
    drawBasis(room.bands, folder + "/basis.png");
    drawBands(room, lighting, settings, workers, folder + "/bands.png");
}

} // namespace odraz::radiosity

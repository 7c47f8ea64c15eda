// What the shared object consists of, beside the engine.
#include "inside.h"
#include "maker/live.h"
#include "show/font.h"

#include <initializer_list>

namespace odraz {

namespace {

constexpr int kMostWide = 4096, kLineHeight = 26, kSize = 12, kIndent = 12, kBarHeight = 4; // pixels
constexpr int kMostLetters = 400;
constexpr float kWidest = 17.5f / 12 * kSize; // of a letter, with what is behind it
float theStrip[3][kMostWide * kLineHeight];   // one line of text

void writeLine(const Picture &p, int top, const char *text) {
    Frame strip = {p.width, kLineHeight, kMostWide, {theStrip[0], theStrip[1], theStrip[2]},
                   nullptr, nullptr};
    __builtin_memset(theStrip, 0, sizeof theStrip);
    drawText(strip, text, kIndent, kLineHeight - 8, kSize, 0.12f, 1, Align::Left, {1, 1, 1}, 1);
    for (int y = 0; y < kLineHeight; ++y)
        for (int x = 0; x < p.width; ++x) {
            uint8_t *pixel = p.rgba + ((ptrdiff_t)(top + y) * p.width + x) * 4;
            float cover = theStrip[0][y * kMostWide + x];
            for (int c = 0; c < 3; ++c) {
                float under = (float)pixel[c] * 0.3f;
                pixel[c] = (uint8_t)(under + (255 - under) * min(cover, 1.f));
            }
        }
}

void fillBar(const Picture &p, float done) {
    for (int y = p.height - kBarHeight; y < p.height; ++y)
        for (int x = 0; x < (int)((float)p.width * done); ++x) {
            uint8_t *pixel = p.rgba + ((ptrdiff_t)y * p.width + x) * 4;
            pixel[0] = 0xd9, pixel[1] = 0x7a, pixel[2] = 0x3c; // copper
        }
}

// How many letters of the text fit on a line of `most`, which ends at a blank if there is one.
int lineLength(const char *text, int most) {
    int length = 0;
    while (length < most && text[length]) ++length;
    if (!text[length]) return length;
    for (int i = length; i > most / 2; --i)
        if (text[i - 1] == ' ') return i;
    return length;
}

void write(const Picture &p, const char *text, float done) {
    int most = min((int)((float)(p.width - 2 * kIndent) / kWidest * 1.6f), kMostLetters), lines = 0;
    if (p.width > kMostWide || most < 1) return;
    for (const char *at = text; *at; at += lineLength(at, most)) ++lines;
    for (int top = p.height - kBarHeight - lines * kLineHeight; *text; top += kLineHeight) {
        char line[kMostLetters + 1] = {};
        int length = lineLength(text, most);
        __builtin_memcpy(line, text, (size_t)length);
        if (top >= 0) writeLine(p, top, line);
        text += length;
    }
    fillBar(p, done);
}

// FNV-1a
struct Hash {
    uint64_t value = 0xcbf29ce484222325;
    template <class T> void add(const T *data, int count = 1) {
        for (size_t i = 0; i < sizeof(T) * (size_t)count; ++i)
            value = (value ^ ((const uint8_t *)data)[i]) * 0x100000001b3;
    }
};

// Only of what is used, and of no addresses: they differ from object to object. A film may have a hall that
// is no room, with nothing to solve
template <class AnyHall> void add(Hash &hash, const AnyHall &hall, const Scene &scene) {
    if constexpr (requires { hall.radiosity.bases; }) {
        hash.add(hall.model.charts, hall.model.chartCount);
        hash.add(hall.model.facets, hall.model.facetCount);
        hash.add(scene.mean, scene.materialCount);
        const auto &bases = hall.radiosity.bases;
        for (int count : {bases.skyCount, bases.sunCount, bases.lampCount}) hash.add(&count);
        hash.add(bases.suns, bases.sunCount);
        hash.add(bases.lamps, bases.lampCount);
        auto settings = hallSettings(hall);
        hash.add(&settings);
    }
}
uint64_t hallHash(Arena &arena) {
    Hall *hall = arena.take<Hall>(1);
    Scene *scene = arena.take<Scene>(1);
    if (arena.full) return 0;
    prepareHall(*hall, *scene);
    Hash hash;
    add(hash, *hall, *scene);
    return hash.value;
}

const Live kLive = {
    needsHall,     memoryNeeded, load,
    duration,      sceneAt,      sceneName,
    paceOf,        cameraAt,     picture,
    between,       samplesTaken, outgrown,
    soundMemory,   loadSound,    seekSound,
    soundBlock,    hallHash,     sizeof(Hall) + sizeof(Scene) + 4096,
    write,         findTables,   pathAt,
    replaceTables, backstage,    {sizeof(Intro), sizeof(Scene), sizeof(Hall), sizeof(Sound)},
};

} // namespace

extern "C" [[gnu::visibility("default")]] const Live *odrazLive() { return &kLive; }

} // namespace odraz

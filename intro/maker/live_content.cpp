// What the shared object consists of, beside the engine.
#include "inside.h"
#include "maker/live.h"
#include "show/font.h"

namespace odraz {

namespace {

constexpr int kMostWide = 4096, kLineHeight = 26, kSize = 12, kIndent = 12; // pixels
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

void write(const Picture &p, const char *text) {
    int each = (int)((float)(p.width - 2 * kIndent) / kWidest * 1.6f), length = (int)__builtin_strlen(text);
    if (p.width > kMostWide || each < 1) return;
    each = min(each, kMostLetters);
    int lines = (length + each - 1) / each, top = p.height - lines * kLineHeight;
    for (int i = 0; i < lines; ++i, top += kLineHeight) {
        char line[kMostLetters + 1] = {};
        __builtin_memcpy(line, text + i * each, (size_t)min(each, length - i * each));
        if (top >= 0) writeLine(p, top, line);
    }
}

const Live kLive = {
    needsHall,   memoryNeeded, load,
    duration,    sceneAt,      sceneName,
    paceOf,      cameraAt,     picture,
    between,     samplesTaken, outgrown,
    soundMemory, loadSound,    seekSound,
    soundBlock,  write,        {sizeof(Intro), sizeof(Scene), sizeof(Hall), sizeof(Sound)},
};

} // namespace

extern "C" [[gnu::visibility("default")]] const Live *odrazLive() { return &kLive; }

} // namespace odraz

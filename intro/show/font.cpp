#include "show/font.h"

#include "base/maths.h"

namespace odraz {

namespace {

// Letters on a grid: baseline 0, lower-case height 8, digits and ascenders 12, descenders -4. Their strokes
// are kLine x0 y0 x1 y1 and kArc cx cy r start sweep (eighths of a turn, counter-clockwise from the right).
enum : int8_t { kEnd = -100, kLine, kArc };
#define L kLine,
#define A kArc,

// clang-format off
const int8_t kGlyphs[] = {
    'a', A 4, 4, 4, 0, 8, L 8, 8, 8, 0, kEnd,
    'b', A 4, 4, 4, 0, 8, L 0, 12, 0, 0, kEnd,
    'c', A 4, 4, 4, 1, 6, kEnd,
    'd', A 4, 4, 4, 0, 8, L 8, 12, 8, 0, kEnd,
    'e', A 4, 4, 4, 0, 7, L 0, 4, 8, 4, kEnd,
    'f', A 5, 9, 3, 2, 2, L 2, 9, 2, 0, L 0, 8, 5, 8, kEnd,
    'g', A 4, 4, 4, 0, 8, L 8, 8, 8, 0, A 4, 0, 4, 5, 3, kEnd,
    'h', L 0, 12, 0, 0, A 4, 4, 4, 0, 4, L 8, 4, 8, 0, kEnd,
    'i', L 0, 8, 0, 0, L 0, 11, 0, 11, kEnd,
    'j', L 2, 8, 2, -2, A 0, -2, 2, 6, 2, L 2, 11, 2, 11, kEnd,
    'k', L 0, 12, 0, 0, L 6, 8, 0, 3, L 2, 5, 6, 0, kEnd,
    'l', L 0, 12, 0, 0, kEnd,
    'm', L 0, 8, 0, 0, A 3, 5, 3, 0, 4, L 6, 5, 6, 0, A 9, 5, 3, 0, 4, L 12, 5, 12, 0, kEnd,
    'n', L 0, 8, 0, 0, A 4, 4, 4, 0, 4, L 8, 4, 8, 0, kEnd,
    'o', A 4, 4, 4, 0, 8, kEnd,
    'p', A 4, 4, 4, 0, 8, L 0, 8, 0, -4, kEnd,
    'q', A 4, 4, 4, 0, 8, L 8, 8, 8, -4, kEnd,
    'r', L 0, 8, 0, 0, A 4, 4, 4, 1, 3, kEnd,
    's', A 2, 6, 2, 1, 5, A 2, 2, 2, 2, -5, kEnd,
    't', L 2, 11, 2, 3, A 5, 3, 3, 4, 2, L 0, 8, 5, 8, kEnd,
    'u', L 0, 8, 0, 4, A 4, 4, 4, 4, 4, L 8, 8, 8, 0, kEnd,
    'v', L 0, 8, 4, 0, L 4, 0, 8, 8, kEnd,
    'w', L 0, 8, 3, 0, L 3, 0, 6, 8, L 6, 8, 9, 0, L 9, 0, 12, 8, kEnd,
    'x', L 0, 8, 7, 0, L 7, 8, 0, 0, kEnd,
    'y', L 0, 8, 4, 0, L 8, 8, 2, -4, kEnd,
    'z', L 0, 8, 7, 8, L 7, 8, 0, 0, L 0, 0, 7, 0, kEnd,
    '0', L 0, 4, 0, 8, A 4, 8, 4, 0, 4, L 8, 8, 8, 4, A 4, 4, 4, 4, 4, kEnd,
    '1', L 0, 9, 3, 12, L 3, 12, 3, 0, kEnd,
    '2', A 4, 8, 4, 4, -5, L 7, 5, 0, 0, L 0, 0, 8, 0, kEnd,
    '3', A 3, 9, 3, 3, -5, A 3, 3, 3, 2, -5, kEnd,
    '4', L 6, 12, 0, 4, L 0, 4, 8, 4, L 6, 12, 6, 0, kEnd,
    '5', L 7, 12, 1, 12, L 1, 12, 1, 7, A 4, 4, 4, 3, -6, kEnd,
    '6', A 4, 4, 4, 0, 8, L 1, 7, 5, 12, kEnd,
    '7', L 0, 12, 8, 12, L 8, 12, 2, 0, kEnd,
    '8', A 3, 9, 3, 0, 8, A 3, 3, 3, 0, 8, kEnd,
    '9', A 4, 8, 4, 0, 8, L 7, 5, 3, 0, kEnd,
    '.', L 0, 0, 0, 0, kEnd,
    ',', L 1, 0, 0, -3, kEnd,
    ':', L 0, 1, 0, 1, L 0, 7, 0, 7, kEnd,
    '-', L 0, 5, 5, 5, kEnd,
    '+', L 0, 5, 6, 5, L 3, 8, 3, 2, kEnd,
    '/', L 0, -2, 6, 13, kEnd,
#ifdef ODRAZ_MORE_LETTERS
#include "show/more_letters.h"
#endif
    kEnd,
};
// clang-format on
#undef L
#undef A

constexpr int kMaxStrokes = 48, kArcPieces = 3; // pieces per eighth of a turn

struct Glyph {
    Stroke strokes[kMaxStrokes]; // grid units, y up
    int count;
    float advance;
};

Glyph glyph(char letter) {
    Glyph g = {{}, 0, 6};
    if (letter >= 'A' && letter <= 'Z') letter = (char)(letter - 'A' + 'a');
    // Find the letter
    const int8_t *p = kGlyphs;
    while (*p != kEnd && *p != letter) {
        while (*p != kEnd) p += *p == kLine ? 5 : *p == kArc ? 6 : 1;
        ++p;
    }
    if (*p == kEnd) return g;
    // Add its strokes, with arcs as short lines
    float right = 0;
    auto add = [&](float x0, float y0, float x1, float y1) {
        g.strokes[g.count++] = {x0, y0, x1, y1};
        right = max(right, max(x0, x1));
    };
    for (++p; *p != kEnd; p += *p == kLine ? 5 : 6) {
        if (*p == kLine) {
            add(p[1], p[2], p[3], p[4]);
            continue;
        }
        int pieces = (p[5] < 0 ? -p[5] : p[5]) * kArcPieces;
        auto along = [&](int i, bool vertical) {
            float angle = (float)(p[4] * kArcPieces + (p[5] < 0 ? -i : i)) * (kPi / (4 * kArcPieces));
            return vertical ? (float)p[2] + (float)p[3] * sin(angle) : (float)p[1] + (float)p[3] * cos(angle);
        };
        for (int i = 0; i < pieces && g.count < kMaxStrokes; ++i)
            add(along(i, false), along(i, true), along(i + 1, false), along(i + 1, true));
    }
    g.advance = right + 3.5f;
    return g;
}

} // namespace

void drawText(Frame &frame, const char *text, float x, float y, const TextStyle &style) {
    if (style.opacity <= 0) return;
    float unit = style.size / 12, width = 0;
    for (const char *c = text; *c; ++c) width += (glyph(*c).advance + style.tracking) * unit;
    x -= style.align == Align::Centre ? width * 0.5f : style.align == Align::Right ? width : 0;
    for (const char *c = text; *c; ++c) {
        Glyph g = glyph(*c);
        for (int i = 0; i < g.count; ++i) {
            Stroke &s = g.strokes[i];
            s = {x + s.x0 * unit, y - s.y0 * unit, x + s.x1 * unit, y - s.y1 * unit};
        }
        if (g.count)
            drawStrokes(frame, g.strokes, g.count, max(style.size * style.weight * 0.5f, 0.35f),
                        style.radiance, style.opacity);
        x += (g.advance + style.tracking) * unit;
    }
}

Vec3 addText(Scene &scene, const char *text, const Vec3 &origin, float unit, float rows, int material,
             int next) {
    constexpr float kBeat = 4, kPen = 8, kRadius = 0.42f; // rows; units per row; units
    float x = 0, beat = -kBeat, pen = 0, ended = 0;
    Vec3 tip = {};
    for (const char *c = text; *c; ++c) {
        Glyph g = glyph(*c);
        bool before = false;
        for (int i = 0; i < g.count; ++i) {
            const Stroke &s = g.strokes[i];
            Vec3 stroke = {s.x1 - s.x0, s.y1 - s.y0, 0}, from = {x + s.x0, kRadius + s.y0, 0};
            float size = length(stroke);
            bool arc = size < 1.5f; // the pieces of arcs are shorter than any line
            if (i == 0 || arc != before) pen = beat += kBeat, material += next;
            before = arc;
            float drawn = min((rows - pen) * kPen, size);
            // The pen glides to the start of its next stroke
            if (drawn <= 0)
                return origin + lerp(tip, from, saturate((rows - ended) / max(pen - ended, 1e-3f))) * unit;
            ended = pen += size * (1 / kPen);
            Vec3 along = stroke * (1 / size), middle = from + along * (drawn * 0.5f);
            tip = from + along * drawn;
            Shape *tube = scene.add(
                cylinder(origin + middle * unit, kRadius * unit, (drawn * 0.5f + 0.1f) * unit, material));
            tube->frame = {{along.y, -along.x, 0}, along, {0, 0, 1}};
        }
        x += g.advance + 0.5f;
    }
    return origin + tip * unit;
}

} // namespace odraz

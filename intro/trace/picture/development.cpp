#include "trace/picture/development.h"

#include "base/maths.h"
#include "base/random.h"

namespace odraz {

Float8 filmic(Float8 x) {
    x = clamp(x, 0.f, 1e6f);
    return x * fmadd(x, 2.51f, 0.03f) / fmadd(x, fmadd(x, 2.51f, 0.59f), 0.14f);
}

Float8 encodeSrgb(Float8 x) {
    return select(x <= 0.0031308f, x * 12.92f, fmadd(pow(x, 1 / 2.4f), 1.055f, -0.055f));
}

void develop(Frame &frame, Workers &workers, float exposure) {
    parallelRanges(workers, frame.height, 16, [&](int first, int end, int) {
        for (int y = first; y < end; ++y) {
            uint8_t *out = frame.rgba + (size_t)y * (size_t)frame.width * 4;
            for (int x = 0; x < frame.width; x += 8) {
                Uint8 place = (Uint8)(kLanes + (x + y * kMaxWidth));
                Float8 noise = toFloat((Int8)(pcg(place) >> 8)) * (1.f / 16777216.f);
                Int8 pixels = broadcast((int32_t)0xff000000);
                for (int c = 0; c < 3; ++c) {
                    Float8 v = load(frame.plane[c] + (size_t)y * (size_t)frame.stride + x);
                    Float8 shown = encodeSrgb(filmic(v * exposure));
                    pixels |= toInt(clamp(fmadd(shown, 255.f, noise), 0.f, 255.f)) << (8 * c);
                }
                // A row's end may not run over the next one's start, which another worker writes
                if (x + 8 <= frame.width)
                    _mm256_storeu_si256((__m256i *)(out + x * 4), (__m256i)pixels);
                else
                    for (int k = 0; k < frame.width - x; ++k)
                        for (int c = 0; c < 4; ++c) out[(x + k) * 4 + c] = (uint8_t)(pixels[k] >> (8 * c));
            }
        }
    });
}

} // namespace odraz

#include "transfer/relight.h"

namespace odraz {

void relight(const Radiosity &r, const Model &model, const LightVector &light, float *const plane[3]) {
    for (int c = 0; c < 3; ++c) {
        // Take the lit bases four at a time, so that each sum is loaded and stored once for four bases
        const float *from[2 * kMaxBases + 3];
        float weight[2 * kMaxBases + 3];
        int count = 0;
        auto add = [&](const float *plane, Rgb weights) {
            float w = c == 0 ? weights.x : c == 1 ? weights.y : weights.z;
            if (w != 0) from[count] = plane, weight[count++] = w;
        };
        for (int k = 0; k < r.bases.count(); ++k) {
            add(r.bounced[k][c], light.bounced[k]);
            add(r.direct[k], light.direct[k]);
        }
        for (int k = 0; k < 3; ++k) from[count + k] = plane[c], weight[count + k] = 0;

        constexpr int kPiece = 512; // texels; their sums stay in the L1 cache
        for (int first = 0; first < model.texelCount; first += kPiece) {
            int end = min(first + kPiece, model.texelCount);
            for (int t = first; t < end; t += 8) store(plane[c] + t, Float8{});
            for (int k = 0; k < count; k += 4)
                for (int t = first; t < end; t += 8) {
                    Float8 sum = load(plane[c] + t);
#pragma GCC unroll 4
                    for (int i = 0; i < 4; ++i) sum = fmadd(load(from[k + i] + t), weight[k + i], sum);
                    store(plane[c] + t, sum);
                }
        }
    }
}

} // namespace odraz

#include "transfer/relight.h"

namespace odraz {

void relight(const Radiosity &r, const Model &model, const LightVector &light, float *const plane[3]) {
    constexpr int kPiece = 512; // texels whose sums stay in the nearest cache
    for (int c = 0; c < 3; ++c)
        for (int first = 0; first < model.texelCount; first += kPiece) {
            int end = min(first + kPiece, model.texelCount);
            float *sum = plane[c];
            for (int t = first; t < end; t += 8) store(sum + t, Float8{});
            auto add = [&](const float *from, Rgb weights) {
                float weight = c == 0 ? weights.x : c == 1 ? weights.y : weights.z;
                if (weight == 0) return;
                for (int t = first; t < end; t += 8)
                    store(sum + t, fmadd(load(from + t), weight, load(sum + t)));
            };
            for (int k = 0; k < r.lights.bases(); ++k) {
                add(r.bounced[k][c], light.bounced[k]);
                add(r.direct[k], light.direct[k]);
            }
        }
}

} // namespace odraz

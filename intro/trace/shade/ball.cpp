#include "trace/shade/ball.h"

#include "base/maths.h"

namespace odraz {

Float8 ballFormFactor(Float8 cosine, Float8 sine2) {
    sine2 = clamp(sine2, 0.f, 0.9999f);
    Float8 cosine2 = cosine * cosine;
    Float8 whole = max(cosine, 0.f) * sine2;
    Int8 cut = cosine2 < sine2;
    if (!any(cut)) return whole;
    // Where the horizon cuts the ball, compute the part above it
    Float8 k2 = max(sine2 - cosine2, 0.f), rest = 1.f - sine2;
    Float8 edge = acos(clamp(-cosine * sqrt(rest / max(sine2 * (1.f - cosine2), 1e-20f)), -1.f, 1.f));
    Float8 slice = kPi * 0.5f - acos(sqrt(k2 / max(rest + k2, 1e-20f)));
    Float8 part = (sine2 * cosine * edge - sqrt(k2 * rest) + slice) * (1.f / kPi);
    return select(cut, max(part, 0.f), whole);
}

} // namespace odraz

#include "output/samples.h"

#include "base/maths.h"
#include "base/random.h"

namespace odraz {

void quantize(const float *block, int number, int16_t *samples) {
    for (int i = 0; i < 2 * kSoundBlock; ++i) {
        // Add dither, which turns rounding errors into noise: the difference of two random numbers
        uint32_t random = pcg((uint32_t)(2 * kSoundBlock * number + i));
        float dither = (float)((int)(random & 0xffff) - (int)(random >> 16)) * (1.f / 65536);
        samples[i] = (int16_t)(int)round(fmadd(block[i], 32767.f, dither));
    }
}

} // namespace odraz

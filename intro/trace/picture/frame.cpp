#include "trace/picture/frame.h"

namespace odraz {

bool makeFrame(Frame &frame, Arena &arena, int width, int height) {
    frame = {width, height, (width + 7) & ~7, {}, nullptr, nullptr};
    size_t floats = (size_t)frame.stride * (size_t)height;
    for (float *&plane : frame.plane)
        if (!(plane = arena.take<float>(floats))) return false;
    uint8_t *bytes = arena.take<uint8_t>((size_t)width * (size_t)height * 4 + kPictureMargin);
    frame.rgba = bytes + kPictureMargin;
    return bytes != nullptr;
}

} // namespace odraz

#include "trace/picture/frame.h"

namespace odraz {

bool makeFrame(Frame &frame, Arena &arena, int width, int height) {
    frame = {width, height, (width + 7) & ~7, {}, nullptr, nullptr};
    size_t floats = (size_t)frame.stride * (size_t)height;
    for (float *&plane : frame.plane) plane = arena.take<float>(floats);
    frame.rgba = arena.take<uint8_t>((size_t)width * (size_t)height * 4 + kPictureMargin) + kPictureMargin;
    return !arena.full;
}

} // namespace odraz

#include "trace/picture/frame.h"

namespace odraz {

bool makeFrame(Frame &frame, Arena &arena, int width, int height) {
    frame = {};
    resize(frame, width, height);
    size_t floats = (size_t)frame.stride * (size_t)height;
    for (float *&plane : frame.plane) plane = arena.allocate<float>(floats);
    frame.rgba =
        arena.allocate<uint8_t>((size_t)width * (size_t)height * 4 + 2 * kPictureMargin) + kPictureMargin;
    return !arena.full;
}

void resize(Frame &frame, int width, int height) {
    frame.width = width, frame.height = height;
    frame.stride = (width + 7) & ~7;
}

} // namespace odraz

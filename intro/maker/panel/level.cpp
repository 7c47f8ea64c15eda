#include "maker/panel/level.h"

#include "maker/panel/mapped_arena.h"

#include <cmath>

namespace odraz::maker {

void Envelope::start(const Inspector &inspector, double seconds) {
    stop();
    blocks.assign((size_t)std::ceil(seconds / kBlock), {});
    thread = std::thread([this, &inspector] { render(inspector); });
}

void Envelope::stop() {
    leave = true;
    if (thread.joinable()) thread.join();
    leave = false;
    done = 0;
}

void Envelope::render(const Inspector &inspector) {
    MappedArena memory(inspector.soundMemory());
    Sound *sound = memory.arena.base ? inspector.loadSound(memory.arena) : nullptr;
    if (!sound) return;
    for (size_t i = 0; i < blocks.size() && !leave; ++i) {
        float stereo[2 * kSoundBlock];
        inspector.soundBlock(*sound, stereo);
        for (int k = 0; k < kSoundBlock; ++k)
            blocks[i].raise({std::abs(stereo[2 * k]), std::abs(stereo[2 * k + 1])});
        done.store((int)i + 1, std::memory_order_release);
    }
}

Level Envelope::most(double from, double to) const {
    int count = done.load(std::memory_order_acquire), first = std::max((int)(from / kBlock), 0),
        end = std::min(std::max((int)std::ceil(to / kBlock), first + 1), count);
    Level level;
    for (int i = first; i < end; ++i) level.raise(blocks[(size_t)i]);
    return level;
}

float decibels(float amplitude) {
    return amplitude > 0 ? std::max(20 * std::log10(amplitude), Meter::kFloor) : Meter::kFloor;
}

void Meter::hear(Level level, double passed) {
    const float heard[2] = {decibels(level.left), decibels(level.right)};
    for (int side = 0; side < 2; ++side) {
        bars[side] = std::max({heard[side], bars[side] - kFall * (float)passed, kFloor});
        age[side] += passed;
        if (heard[side] >= peaks[side] || age[side] > kHold) {
            peaks[side] = bars[side];
            age[side] = 0;
        }
    }
}

void drawMeter(Canvas &canvas, Rect r, const Meter &meter) {
    auto up = [&](float db) { return (int)std::lround((db / -Meter::kFloor + 1) * (float)r.height); };
    canvas.fill(r, kGround, 0.75f);
    int wide = (r.width - 3) / 2;
    for (int side = 0; side < 2; ++side) {
        int x = r.x + 1 + side * (wide + 1), high = up(std::min(meter.shown(side), 0.f));
        canvas.fill({x, r.bottom() - high, wide, high}, kCold, 0.85f);
        int hot = high - up(-6);
        if (hot > 0) canvas.fill({x, r.bottom() - high, wide, hot}, kWarm, 0.95f);
        if (meter.peak(side) > Meter::kFloor)
            canvas.fill({x, r.bottom() - up(std::min(meter.peak(side), 0.f)), wide, 2},
                        meter.clipped(side) ? Colour{255, 60, 50} : kInk);
    }
    // Its scale, on a dark ground: a picture may be bright
    float size = textSize(canvas.height()) * 0.75f, figures = widthOf("-36", size) + size;
    canvas.fill({r.x - (int)figures, r.y, (int)figures, r.height}, kGround, 0.75f);
    for (float db : {-6.f, -18.f, -36.f}) {
        canvas.fill({r.x, r.bottom() - up(db), r.width, 1}, kInk, 0.3f);
        canvas.text(std::to_string((int)db), (float)r.x - size * 0.5f,
                    (float)(r.bottom() - up(db)) + size * 0.5f, size, kInk, Align::Right);
    }
}

} // namespace odraz::maker

#include "maker/panel/envelope.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

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
    size_t bytes = inspector.soundMemory() + 64;
    std::unique_ptr<unsigned char, void (*)(void *)> memory((unsigned char *)std::calloc(1, bytes + 64),
                                                            std::free);
    if (!memory) return;
    Arena arena = {memory.get() + (64 - (uintptr_t)memory.get() % 64), bytes, 0};
    Sound *sound = inspector.loadSound(arena);
    if (!sound) return;
    for (size_t i = 0; i < blocks.size() && !leave; ++i) {
        float stereo[2 * kSoundBlock];
        inspector.soundBlock(*sound, stereo);
        for (int k = 0; k < kSoundBlock; ++k) {
            blocks[i].left = std::max(blocks[i].left, std::abs(stereo[2 * k]));
            blocks[i].right = std::max(blocks[i].right, std::abs(stereo[2 * k + 1]));
        }
        done.store((int)i + 1, std::memory_order_release);
    }
}

Level Envelope::most(double from, double to) const {
    int count = done.load(std::memory_order_acquire), first = std::max((int)(from / kBlock), 0),
        end = std::min(std::max((int)std::ceil(to / kBlock), first + 1), count);
    Level level;
    for (int i = first; i < end; ++i) {
        level.left = std::max(level.left, blocks[(size_t)i].left);
        level.right = std::max(level.right, blocks[(size_t)i].right);
    }
    return level;
}

} // namespace odraz::maker

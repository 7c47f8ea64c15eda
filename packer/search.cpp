#include "search.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <random>
#include <thread>

namespace pack {

namespace {

// One mask changed: mostly by a field or two, sometimes for another one altogether. False if that makes no
// difference.
bool mutate(Shape &shape, const Layout &layout, std::mt19937 &random) {
    uint32_t type = random() % layout.size >= layout.codeSize, i = random() % shape.hashes();
    uint16_t *masks = shape.masks[type], &mask = masks[i], before = mask;
    auto field = [&] { return (uint16_t)(1 << random() % (kFields - 1)); };
    switch (random() % 6) {
    case 0:
        mask = (uint16_t)(masks[random() % shape.hashes()] ^ field());
        break;
    case 1:
        mask = 0;
        for (uint32_t count = 1 + random() % 4; count; --count) mask |= field();
        break;
    case 2:
        mask ^= field();
        [[fallthrough]];
    default:
        mask ^= field();
    }
    // A second context alike is a waste
    uint16_t *first = masks + (i < shape.contexts ? 0 : shape.contexts);
    uint16_t *last = masks + (i < shape.contexts ? shape.contexts : shape.hashes());
    return mask != before && std::count(first, last, mask) == 1;
}

} // namespace

Shape search(const std::vector<uint8_t> &filtered, const Layout &layout, const Shape &start, double seconds,
             const std::function<bool(const Progress &)> &goOn) {
    if (filtered.empty()) return start;
    auto began = std::chrono::steady_clock::now();
    auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    Workspace first;
    Shape best = start;
    double least = measure(filtered, layout, start, first);
    int tried = 0;
    std::mutex mutex;
    bool stopped = !goOn({least, passed(), tried});

    auto work = [&](uint32_t seed) {
        std::mt19937 random(seed);
        Workspace workspace;
        std::unique_lock lock(mutex);
        while (!stopped && passed() < seconds) {
            Shape shape = best;
            if (!mutate(shape, layout, random)) continue;
            double limit = least;
            lock.unlock();
            double bytes = measure(filtered, layout, shape, workspace, limit);
            lock.lock();
            ++tried;
            // The best may have changed meanwhile: what was measured is this shape, as a whole
            if (bytes < least) {
                least = bytes;
                best = shape;
            }
            stopped |= !goOn({least, passed(), tried});
        }
    };
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(work, i);
    for (std::thread &t : threads) t.join();
    return best;
}

} // namespace pack

#include "search.h"

#include "estimate.h"
#include "format.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <random>
#include <thread>

namespace pack {

namespace {

// A change of one mask or two, of code (type 0) or data (1).
struct Change {
    struct Setting {
        uint32_t i;
        uint16_t mask;
    };
    uint32_t type;
    std::vector<Setting> settings;

    Shape of(const Shape &before) const {
        Shape shape = before;
        for (Setting s : settings) shape.masks[type][s.i] = s.mask;
        return shape;
    }
    // Not the same as before, nor one that makes two contexts alike, which is a waste
    bool sensible(const Shape &before) const {
        Shape shape = of(before);
        const uint16_t *masks = shape.masks[type], *selectors = masks + shape.contexts;
        for (Setting s : settings) {
            const uint16_t *first = s.i < shape.contexts ? masks : selectors;
            const uint16_t *last = s.i < shape.contexts ? selectors : masks + shape.hashes();
            if (s.mask == before.masks[type][s.i] || std::count(first, last, s.mask) > 1) return false;
        }
        return true;
    }
    uint64_t key() const {
        uint64_t key = type;
        for (Setting s : settings) key = key << 24 | (uint64_t)s.i << 16 | s.mask;
        return key;
    }
};

// Mostly a field more, less or another, sometimes another mask altogether, or two selectors in the other
// order.
Change propose(const Shape &shape, const Layout &layout, std::mt19937 &random) {
    uint32_t data = layout.size - layout.codeSize;
    Change change = {data && (!layout.codeSize || random() % 5 == 0), {}};
    const uint16_t *masks = shape.masks[change.type];
    uint32_t i = random() % shape.hashes();
    uint16_t mask = masks[i];
    auto field = [&] { return (uint16_t)(1 << random() % (kFields - 1)); };
    // One that is in it, or not
    auto fieldOf = [&](uint16_t all) {
        uint16_t one = field();
        while (all && !(one & all)) one = field();
        return one;
    };
    switch (random() % 8) {
    case 0:
        mask = (uint16_t)(masks[random() % shape.hashes()] ^ field());
        break;
    case 1:
        mask = 0;
        for (uint32_t count = 1 + random() % 4; count; --count) mask |= field();
        break;
    case 2: {
        uint32_t a = shape.contexts + random() % (kSets - 1), b = shape.contexts + random() % (kSets - 1);
        if (a != b) {
            change.settings = {{a, masks[b]}, {b, masks[a]}};
            return change;
        }
        break;
    }
    case 3:
        mask ^= field();
        mask ^= field();
        break;
    case 4: // one for another
        mask = (uint16_t)(mask & ~fieldOf(mask));
        mask ^= fieldOf((uint16_t)~mask);
        break;
    default:
        mask ^= field();
    }
    change.settings = {{i, mask}};
    return change;
}

} // namespace

Shape search(const std::vector<uint8_t> &filtered, const Layout &layout, const Shape &start, double seconds,
             const std::function<bool(const Progress &)> &goOn) {
    if (filtered.empty()) return start;
    constexpr double kWorthIt = 0.5;    // bytes that a change must save
    constexpr double kSlack = 24;       // and how far it may be behind on the way there
    constexpr double kMeasureEvery = 8; // times as long as measuring takes
    constexpr int kForget = 10;         // changes after which one may be tried again
    auto began = std::chrono::steady_clock::now();
    auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    Workspace workspace;
    Shape measured = start; // the best by measure
    double least = measure(filtered, layout, start, workspace), measuring = passed();
    int tried = 0, kept = 0;
    bool stopped = !goOn({least, passed(), tried});
    if (stopped || seconds <= passed()) return start;

    // The best by estimate, which the threads take from each other
    auto best = std::make_shared<const Estimate>(Estimator(filtered, layout)(start));
    Shape asked = start; // what was measured last
    double nextMeasure = passed() + kMeasureEvery * measuring;
    std::map<uint64_t, int> triedAt; // changes, and how many had been kept by then
    std::mutex mutex;

    // Measures the best, while others go on
    auto confirm = [&](std::unique_lock<std::mutex> &lock) {
        auto same = [](const Shape &a, const Shape &b) { return packMasks(a) == packMasks(b); };
        if (same(asked, best->shape)) return;
        Shape shape = asked = best->shape;
        nextMeasure = 1e30; // nobody else, not even when the time is over: there is one workspace
        lock.unlock();
        double bytes = measure(filtered, layout, shape, workspace, least);
        lock.lock();
        if (bytes < least) {
            least = bytes;
            measured = shape;
        }
        nextMeasure = passed() + kMeasureEvery * measuring;
    };
    auto work = [&](uint32_t seed) {
        std::mt19937 random(seed);
        Estimator estimator(filtered, layout);
        std::unique_lock lock(mutex);
        while (!stopped && passed() < seconds) {
            Change change = propose(best->shape, layout, random);
            auto [at, fresh] = triedAt.try_emplace(change.key(), kept);
            if (!fresh && kept < at->second + kForget) continue;
            at->second = kept;
            if (!change.sensible(best->shape)) continue;
            ++tried;
            // The best may change meanwhile: then what is good must be so there
            for (bool better = true; better;) {
                auto base = best;
                lock.unlock();
                Estimate estimate = estimator(change.of(base->shape), base.get(), kSlack);
                lock.lock();
                better = estimate.bytes < base->bytes - kWorthIt;
                if (better && best == base) {
                    best = std::make_shared<const Estimate>(std::move(estimate));
                    ++kept;
                    break;
                }
                better = better && change.sensible(best->shape);
            }
            if (passed() > nextMeasure) confirm(lock);
            stopped |= !goOn({least, passed(), tried});
        }
    };
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(work, i);
    for (std::thread &t : threads) t.join();
    std::unique_lock lock(mutex);
    confirm(lock);
    goOn({least, passed(), tried});
    return measured;
}

} // namespace pack

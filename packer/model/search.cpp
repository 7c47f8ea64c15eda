#include "packer/model/search.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <random>
#include <thread>

namespace pack {

namespace {

// A change of one or two masks, of code (type 0) or data (1).
struct Change {
    struct Setting {
        uint32_t i;
        uint32_t mask;
    };
    uint32_t type;
    std::vector<Setting> settings;

    ModelParameters of(const ModelParameters &before) const {
        ModelParameters parameters = before;
        for (Setting s : settings) parameters.masks[type][s.i] = s.mask;
        return parameters;
    }
    // Whether it changes something and leaves no two contexts equal
    bool sensible(const ModelParameters &before) const {
        ModelParameters parameters = of(before);
        const uint32_t *masks = parameters.masks[type], *selectors = masks + parameters.contexts;
        for (Setting s : settings) {
            const uint32_t *first = s.i < parameters.contexts ? masks : selectors;
            const uint32_t *last = s.i < parameters.contexts ? selectors : masks + parameters.hashes();
            if (s.mask == before.masks[type][s.i] || std::count(first, last, s.mask) > 1) return false;
        }
        return true;
    }
    auto key() const {
        std::vector<uint32_t> key = {type};
        for (Setting s : settings) key.insert(key.end(), {s.i, s.mask});
        return key;
    }
};

// Mostly adds, removes or replaces a field; sometimes takes a new mask, or swaps two selectors.
Change propose(const ModelParameters &parameters, const Searched &program, std::mt19937 &random) {
    const MayUse &may = program.mayUse;
    uint32_t data = program.layout.size - program.layout.codeSize;
    Change change = {data && (!program.layout.codeSize || random() % 5 == 0), {}};
    const uint32_t *masks = parameters.masks[change.type];
    uint32_t i = random() % parameters.hashes();
    uint32_t mask = masks[i];
    auto field = [&] {
        return change.type ? 1u << random() % may.dataBits : 1u << (random() % may.codeBits + may.codeShift);
    };
    // A field that is in the mask, or one that is not
    auto fieldOf = [&](uint32_t all) {
        uint32_t one = field();
        while (all && !(one & all)) one = field();
        return one;
    };
    switch (random() % 8) {
    case 0:
        mask = masks[random() % parameters.hashes()] ^ field();
        break;
    case 1:
        mask = 0;
        for (uint32_t count = 1 + random() % 4; count; --count) mask |= field();
        break;
    case 2: {
        uint32_t a = parameters.contexts + random() % (kSets - 1),
                 b = parameters.contexts + random() % (kSets - 1);
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
    case 4: // replace one field by another
        mask &= ~fieldOf(mask);
        mask ^= fieldOf(~mask);
        break;
    default:
        mask ^= field();
    }
    change.settings = {{i, mask}};
    return change;
}

} // namespace

ModelParameters search(const Searched &program, const ModelParameters &start, double seconds,
                       const std::function<bool(const Progress &)> &goOn) {
    if (program.all.empty()) return start;
    constexpr double kWorthIt = 0.5;    // bytes that a change must save
    constexpr double kSlack = 24;       // bytes that it may be behind while it is being estimated
    constexpr double kMeasureEvery = 8; // measurement times from one measurement to the next
    constexpr int kForget = 10;         // kept changes after which a change may be tried again
    auto began = std::chrono::steady_clock::now();
    auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    Workspace workspace;
    ModelParameters measured = start; // the best measured
    double least = program.measure(start, workspace, 1e30), measuring = passed();
    int tried = 0, kept = 0;
    bool stopped = !goOn({least, passed(), tried});
    if (stopped || seconds <= passed()) return start;

    // The best by estimate, shared by the threads
    auto best = std::make_shared<const Estimate>(Estimator(program.all, program.layout)(start));
    ModelParameters asked = start; // what was measured last
    double nextMeasure = passed() + kMeasureEvery * measuring;
    std::map<std::vector<uint32_t>, int>
        triedAt; // for each change tried: how many changes had been kept by then
    std::mutex mutex;

    // Measures the best, while other threads go on
    auto confirm = [&](std::unique_lock<std::mutex> &lock) {
        if (asked == best->parameters) return;
        ModelParameters parameters = asked = best->parameters;
        // There is one workspace: no other thread may measure, even after the time is over
        nextMeasure = 1e30;
        lock.unlock();
        double bytes = program.measure(parameters, workspace, least);
        lock.lock();
        if (bytes < least) {
            least = bytes;
            measured = parameters;
        }
        nextMeasure = passed() + kMeasureEvery * measuring;
    };
    auto work = [&](uint32_t seed) {
        std::mt19937 random(seed);
        Estimator estimator(program.all, program.layout);
        std::unique_lock lock(mutex);
        while (!stopped && passed() < seconds) {
            Change change = propose(best->parameters, program, random);
            auto [at, fresh] = triedAt.try_emplace(change.key(), kept);
            if (!fresh && kept < at->second + kForget) continue;
            at->second = kept;
            if (!change.sensible(best->parameters)) continue;
            ++tried;
            // Another thread may change the best meanwhile: then the change must also improve the new best
            for (bool better = true; better;) {
                auto base = best;
                lock.unlock();
                Estimate estimate = estimator(change.of(base->parameters), base.get(), kSlack);
                lock.lock();
                better = estimate.bytes < base->bytes - kWorthIt;
                if (better && best == base) {
                    best = std::make_shared<const Estimate>(std::move(estimate));
                    ++kept;
                    break;
                }
                better = better && change.sensible(best->parameters);
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

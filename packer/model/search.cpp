#include "packer/model/search.h"

#include "tools/common/clock.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <random>
#include <thread>

namespace pack {

namespace {

// A change of one or two masks, of code (type 0) or data (1).
struct MaskChange {
    struct Setting {
        uint32_t i, mask;
        auto operator<=>(const Setting &) const = default;
    };
    uint32_t type;
    std::vector<Setting> settings;
    auto operator<=>(const MaskChange &) const = default;

    ModelParameters of(const ModelParameters &before) const {
        ModelParameters parameters = before;
        for (Setting s : settings) parameters.masks[type][s.i] = s.mask;
        return parameters;
    }
    // Whether the change has an effect and leaves no two contexts equal.
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
};

// Proposes a random change: most add, remove or replace a field; some choose a new mask or swap selectors.
MaskChange propose(const ModelParameters &parameters, const SearchInput &program, std::mt19937 &random) {
    const MayUse &may = program.mayUse;
    uint32_t data = program.layout.size - program.layout.codeSize;
    MaskChange change = {data && (!program.layout.codeSize || random() % 5 == 0), {}};
    const uint32_t *masks = parameters.masks[change.type];
    uint32_t i = random() % parameters.hashes();
    uint32_t mask = masks[i];
    auto field = [&] {
        return change.type ? 1u << random() % may.dataBits : 1u << (random() % may.codeBits + may.codeShift);
    };
    // Returns a random field of the mask `all`, or any field if the mask is empty
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
        if (a == b) break;
        change.settings = {{a, masks[b]}, {b, masks[a]}};
        return change;
    }
    case 3:
        mask ^= field() ^ field();
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

constexpr double kWorthIt = 0.5;    // bytes that a change must save
constexpr double kSlack = 24;       // an estimate that is this many bytes larger is abandoned
constexpr double kMeasureEvery = 8; // time between two measurements, in durations of a measurement
constexpr int kForget = 10;         // a change may be tried again after this many kept changes

// A search. `mutex` protects all members.
struct Search {
    const SearchInput &program;
    double seconds;
    const OnProgress &onProgress;
    ModelParameters measured; // the best by measurement
    ModelParameters lastMeasured = measured;
    std::shared_ptr<const Estimate> best = {}; // the best by estimate
    double least = 0;                          // bytes of `measured`
    double measuring = 0, nextMeasure = 0;  // duration of a measurement and time of the next one, in seconds
    int tried = 0, kept = 0;                // numbers of changes
    std::map<MaskChange, int> triedAt = {}; // changes tried, with `kept` at that time
    bool stopped = false;
    double began = common::wallSeconds();
    std::mutex mutex = {};

    ModelParameters run() {
        least = program.measure(measured);
        measuring = passed();
        progress();
        if (stopped || seconds <= passed()) return measured;
        best = std::make_shared<const Estimate>(Estimator(program.records)(measured));
        nextMeasure = passed() + kMeasureEvery * measuring;
        std::vector<std::thread> threads;
        for (uint32_t i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
            threads.emplace_back([this, i] { tryChanges(i); });
        for (std::thread &t : threads) t.join();
        std::unique_lock lock(mutex);
        measureBest(lock);
        progress();
        return measured;
    }

    double passed() const { return common::wallSeconds() - began; }
    void progress() { stopped |= !onProgress({least, passed(), tried}); }

    // Runs in each thread of the search.
    void tryChanges(uint32_t seed) {
        std::mt19937 random(seed);
        Estimator estimator(program.records);
        std::unique_lock lock(mutex);
        while (!stopped && passed() < seconds) {
            MaskChange change = propose(best->parameters, program, random);
            auto [at, isNew] = triedAt.try_emplace(change, kept);
            if (!isNew && kept < at->second + kForget) continue;
            at->second = kept;
            if (!change.sensible(best->parameters)) continue;
            ++tried;
            tryChange(change, estimator, lock);
            if (passed() > nextMeasure) measureBest(lock);
            progress();
        }
    }

    // Estimates a change of the best parameters, without the lock. If another thread has replaced them
    // meanwhile, the change must improve the new ones too.
    void tryChange(const MaskChange &change, Estimator &estimator, std::unique_lock<std::mutex> &lock) {
        for (bool better = true; better;) {
            auto base = best;
            lock.unlock();
            Estimate estimate = estimator(change.of(base->parameters), base.get(), kSlack);
            lock.lock();
            better = estimate.bytes < base->bytes - kWorthIt;
            if (better && best == base) {
                best = std::make_shared<const Estimate>(std::move(estimate));
                ++kept;
                return;
            }
            better = better && change.sensible(best->parameters);
        }
    }

    // Measures the best parameters, without the lock, so that other threads can continue.
    void measureBest(std::unique_lock<std::mutex> &lock) {
        if (lastMeasured == best->parameters) return;
        ModelParameters parameters = lastMeasured = best->parameters;
        // A measurement takes much memory, so no other thread may measure now, even if the search is over
        nextMeasure = 1e30;
        lock.unlock();
        double bytes = program.measure(parameters);
        lock.lock();
        if (bytes < least) {
            least = bytes;
            measured = parameters;
        }
        nextMeasure = passed() + kMeasureEvery * measuring;
    }
};

} // namespace

ModelParameters search(const SearchInput &program, const ModelParameters &start, double seconds,
                       const OnProgress &onProgress) {
    return program.records.empty() ? start : Search{program, seconds, onProgress, start}.run();
}

} // namespace pack

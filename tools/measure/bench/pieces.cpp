#include "tools/measure/bench/pieces.h"

#include "tools/common/clock.h"
#include "tools/engine/machine.h"

#include <algorithm>

namespace odraz {

Pieces::Pieces() {
    auto run = [](Workers &w, int count, int size, void (*body)(const void *, int, int, int),
                  const void *context) { ((Pieces *)w.host)->run(count, size, body, context); };
    theWorkers = {1, run, &kNever, this};
}

void Pieces::begin() {
    next = 0;
    last = common::threadSeconds();
}

void Pieces::end() { after = std::min(after, common::threadSeconds() - last); }

void Pieces::run(int count, int size, void (*body)(const void *, int, int, int), const void *context) {
    double before = common::threadSeconds() - last;
    if (next == rounds.size())
        rounds.push_back({before, std::vector<double>((size_t)((count + size - 1) / size), 1e9)});
    Round &r = rounds[next++];
    r.before = std::min(r.before, before);
    for (int i = 0; i < count; i += size) {
        double began = common::threadSeconds();
        body(context, i, std::min(i + size, count), 0);
        double &least = r.pieces[(size_t)(i / size)];
        least = std::min(least, common::threadSeconds() - began);
    }
    last = common::threadSeconds();
}

double Pieces::serial() const {
    double sum = after;
    for (const Round &r : rounds) sum += r.before;
    return sum;
}

double Pieces::all() const {
    double sum = serial();
    for (const Round &r : rounds)
        for (double piece : r.pieces) sum += piece;
    return sum;
}

double Pieces::with(int count) const {
    constexpr double kWake = 8e-6;
    double sum = serial();
    for (const Round &r : rounds) {
        std::vector<double> free((size_t)count);
        for (double piece : r.pieces) *std::min_element(free.begin(), free.end()) += piece;
        sum += *std::max_element(free.begin(), free.end()) + (count > 1 ? kWake : 0);
    }
    return sum;
}

} // namespace odraz

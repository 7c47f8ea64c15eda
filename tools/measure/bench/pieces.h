// How a picture would share out among workers: predicted from one thread, so for machines that are not here.
#pragma once

#include "base/parallel.h"

#include <vector>

namespace odraz {

// Workers that run all pieces on the calling thread and note what each takes, and what the work between them.
// From several runs of the same work the least counts.
class Pieces {
public:
    Pieces();
    Pieces(const Pieces &) = delete;
    Workers &workers() { return theWorkers; }
    // Before and after each run.
    void begin();
    void end();

    double serial() const; // seconds outside all pieces
    double all() const;    // ... and those in them
    // Seconds that `count` workers take, each of which takes the next piece as soon as it is free. Waking
    // them takes 8 microseconds, as measured for two.
    double with(int count) const;

private:
    struct Round {
        double before; // serial work before it
        std::vector<double> pieces;
    };
    Workers theWorkers;
    std::vector<Round> rounds;
    double after = 1e9, last = 0;
    size_t next = 0;

    void run(int count, int size, void (*body)(const void *, int, int, int), const void *context);
};

} // namespace odraz

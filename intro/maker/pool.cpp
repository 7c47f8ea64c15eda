#include "maker/pool.h"

#include <algorithm>

namespace odraz::maker {

Pool::Pool(int count)
    : all{std::clamp(count, 1, kMaxWorkers),
          [](Workers &w, int count, int size, void (*body)(const void *, int, int, int),
             const void *context) {
              Pool &pool = *(Pool *)w.host;
              pool.job.begin(w, count, size, body, context);
              pool.begins.arrive_and_wait();
              pool.job.take(0);
              pool.ends.arrive_and_wait();
          },
          &leave, this},
      begins(all.count), ends(all.count) {
    for (int i = 1; i < all.count; ++i)
        threads.emplace_back([this, i] {
            for (begins.arrive_and_wait(); !over; begins.arrive_and_wait()) {
                job.take(i);
                ends.arrive_and_wait();
            }
        });
}

Pool::~Pool() {
    over = true;
    begins.arrive_and_wait();
}

} // namespace odraz::maker

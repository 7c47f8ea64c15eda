// Stillness: spans of seconds in which hardly anything changes.
#pragma once

#include <vector>

namespace odraz::measure {

// Seconds from .. to - 1.
struct Piece {
    int from, to;
};

// The pieces of `hold` seconds or more that are still. changes[i] is the difference of second i + 1 from
// second i. In any `hold` seconds of a piece the mean of these changes is less than `limit`.
std::vector<Piece> stillPieces(const std::vector<double> &changes, int hold, double limit);

} // namespace odraz::measure

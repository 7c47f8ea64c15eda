// Stillness: seconds in one piece in which hardly anything changes.
#pragma once

#include <vector>

namespace odraz::measure {

// Seconds from .. to - 1.
struct Piece {
    int from, to;
};

// The pieces of `hold` seconds or more that stand still. changes[i] tells how much second i + 1 differs from
// second i. In every `hold` seconds of a piece the mean of these changes is less than `limit`.
std::vector<Piece> stillPieces(const std::vector<double> &changes, int hold, double limit);

} // namespace odraz::measure

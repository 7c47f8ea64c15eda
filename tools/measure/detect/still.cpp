#include "tools/measure/detect/still.h"

namespace odraz::measure {

std::vector<Piece> stillPieces(const std::vector<double> &changes, int hold, double limit) {
    std::vector<Piece> pieces;
    int between = hold - 1; // changes within `hold` seconds
    for (int i = 0; i + between <= (int)changes.size(); ++i) {
        double sum = 0;
        for (int k = i; k < i + between; ++k) sum += changes[(size_t)k];
        if (!(sum < limit * between)) continue;
        if (pieces.empty() || pieces.back().to <= i)
            pieces.push_back({i, i + hold});
        else
            pieces.back().to = i + hold;
    }
    return pieces;
}

} // namespace odraz::measure

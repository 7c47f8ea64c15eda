// The film's length: the only content that is known before the film is decoded.
#pragma once

namespace odraz {

constexpr float kEndRow = 80; // 8 rows a second: four bars, and one in which they ring out

} // namespace odraz

// The film's length, which is known before the film is decoded.
#pragma once

namespace odraz {

constexpr float kEndRow = 80; // 8 rows a second: four bars of music, and one in which it fades

} // namespace odraz

// The film's length: the only content that is known before the film is decoded.
#pragma once

namespace odraz {

constexpr float kEndRow = 1312; // 8 rows a second

} // namespace odraz

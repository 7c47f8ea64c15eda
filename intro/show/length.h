// How long the film is: all of its content that is known before it is decoded.
#pragma once

namespace odraz {

constexpr float kEndRow = 1296; // 8 rows a second

} // namespace odraz

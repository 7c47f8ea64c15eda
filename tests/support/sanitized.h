// Sweeps test fewer cases under sanitizers, where everything takes five times as long: there they look for
// misused memory, not for figures. Without sanitizers they test all cases.
#pragma once

namespace odraz {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

// The GTEST_SKIP() message of tests that only check figures of code which other tests run too.
constexpr const char *kFiguresAlone = "it looks at figures, which sanitizers do not change";

} // namespace odraz

// Sanitizers make tests five times as slow, and find misused memory, not wrong figures. So with them sweeps
// test fewer cases.
#pragma once

namespace odraz {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

// The GTEST_SKIP() message of tests that only check figures of code which other tests run too.
constexpr const char *kFiguresAlone = "it checks figures, which sanitizers do not change";

} // namespace odraz

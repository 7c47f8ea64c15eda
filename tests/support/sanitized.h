// Under sanitizers, which take five times as long, tests look for misused memory, not for figures: sweeps
// test fewer cases there.
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

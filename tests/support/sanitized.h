// Sanitizers make tests five times as slow, and find misused memory, not wrong figures. So with them sweeps
// test fewer cases, and a FIGURES_TEST, which only checks figures of code that other tests run too, is
// skipped.
#pragma once

#ifdef __SANITIZE_ADDRESS__
#define FIGURES_TEST(suite, name) TEST(suite, DISABLED_##name)
constexpr bool kSanitized = true;
#else
#define FIGURES_TEST TEST
constexpr bool kSanitized = false;
#endif

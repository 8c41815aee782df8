// How often a test of random cases is tried.
#pragma once

namespace filum {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

// n; with sanitizers a tenth, at least 1: they look at the memory, and each trial takes ten times as long.
constexpr int trials(int n) { return !kSanitized ? n : n < 10 ? 1 : n / 10; }

// Ends a test that has nothing new for sanitizers: other tests run the same code, and this one only compares.
#define FILUM_NOT_SANITIZED()                                                                                          \
    if (kSanitized) GTEST_SKIP() << "other tests run the same code with sanitizers"

} // namespace filum

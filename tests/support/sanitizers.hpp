// What a sanitizer build can and cannot test.
#pragma once

namespace pathrace::testing {

// libgomp and the packaged TBB are not instrumented: the thread sanitizer would report their own locks.
#if defined(__SANITIZE_THREAD__)
inline constexpr bool thread_sanitizer = true;
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
inline constexpr bool thread_sanitizer = true;
#else
inline constexpr bool thread_sanitizer = false;
#endif
#else
inline constexpr bool thread_sanitizer = false;
#endif

// Instrumented code is slow: long tests take fewer cases.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool instrumented = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool instrumented = true;
#else
inline constexpr bool instrumented = thread_sanitizer;
#endif
#else
inline constexpr bool instrumented = thread_sanitizer;
#endif

}  // namespace pathrace::testing

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

}  // namespace pathrace::testing

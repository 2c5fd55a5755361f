// The floating-point environment: rounding to nearest, subnormal numbers kept, no traps, whatever the code
// before has set. Results are bit-identical only in one environment, and a thread keeps what it was given.
#pragma once

#include <cfenv>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace pathrace::bench {

/// The default environment until the end of a scope, then the one before.
class DefaultFloats {
 public:
  DefaultFloats() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  DefaultFloats(const DefaultFloats&) = delete;
  DefaultFloats& operator=(const DefaultFloats&) = delete;
  ~DefaultFloats() { std::fesetenv(&before_); }

 private:
  std::fenv_t before_;
};

/// The same for a chunk of a loop, in some nanoseconds: of the register that doubles are computed by (MXCSR),
/// and without its flags. Elsewhere than on x86, all of it.
#if defined(__SSE2__)
class DefaultFloatsInChunk {
 public:
  DefaultFloatsInChunk() : before_(control()) { set(usual); }
  DefaultFloatsInChunk(const DefaultFloatsInChunk&) = delete;
  DefaultFloatsInChunk& operator=(const DefaultFloatsInChunk&) = delete;
  ~DefaultFloatsInChunk() { set(before_); }

 private:
  static constexpr unsigned flags = 0x3F;
  static constexpr unsigned usual = 0x1F80;  // to nearest, all exceptions masked, no flush to zero

  static unsigned control() { return _mm_getcsr() & ~flags; }
  static void set(unsigned due) {
    if (control() != due) _mm_setcsr(due);
  }

  unsigned before_;
};
#else
using DefaultFloatsInChunk = DefaultFloats;
#endif

}  // namespace pathrace::bench

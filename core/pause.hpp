// Waiting for another thread without giving the processor away.
#pragma once

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace pathrace {

/// Tells the processor that this thread only waits: between two looks at what it waits for.
inline void pause_briefly() {
#ifdef __x86_64__
  _mm_pause();
#endif
}

}  // namespace pathrace

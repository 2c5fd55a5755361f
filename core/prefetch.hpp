// Asking for memory ahead of its use.
//
// g++ takes a function that does nothing but prefetch for one without any effect, and drops calls of it. The
// empty asm statement is an effect in its eyes, and no instruction.
#pragma once

namespace pathrace {

/// Asks for the cache line of `address`, to read it soon. Any address will do.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");
}

/// The same, to write to it soon: other cores lose the line.
inline void prefetch_to_write(const void* address) {
  __builtin_prefetch(address, 1);
  asm volatile("");
}

}  // namespace pathrace

// Memory on huge pages, for arrays that are read all over the place.
//
// An ant on a large map reads a cache line here and one there; with pages of 4 KiB the processor would also
// look most of their addresses up in memory. A hint to the kernel, which may have no such pages to give.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace pathrace::algorithms {

template <typename T>
class HugePages {
 public:
  using value_type = T;  // NOLINT(readability-identifier-naming): the standard library asks for this name

  HugePages() = default;
  template <typename U>
  explicit HugePages(const HugePages<U>&) {}

  /// Arrays below the size of a huge page get what `new` gives.
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* memory = ::operator new(bytes, alignment_of(count));
    if (bytes >= page) madvise(memory, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment_of(count)); }

  friend bool operator==(const HugePages&, const HugePages&) { return true; }

 private:
  static constexpr std::size_t page = std::size_t{1} << 21;

  static constexpr std::align_val_t alignment_of(std::size_t count) {
    return std::align_val_t{count * sizeof(T) >= page ? page : alignof(T)};
  }
};

}  // namespace pathrace::algorithms

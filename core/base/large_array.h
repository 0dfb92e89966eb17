#pragma once
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace ps {

/// Memory that begins on a cache line; much of it on a large page, which saves the processor most of its address
/// look-ups in a data structure that is visited here and there.
template <class T>
struct LargePages {
  using value_type = T;
  static constexpr std::size_t cache_line = 64, page = std::size_t{1} << 21;
  static_assert(alignof(T) <= cache_line);

  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) noexcept {}

  T* allocate(std::size_t count) {
    const std::size_t alignment = count >= 2 * page / sizeof(T) ? page : cache_line;
    if (count > (~std::size_t{0} - alignment) / sizeof(T)) throw std::bad_alloc();
    const std::size_t bytes = (count * sizeof(T) + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    if (alignment == page) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));  // a wish; failure does no harm
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) noexcept { std::free(memory); }
  /// What resize() adds has no value that its type does not give it: several threads are to write it.
  template <class Element>
  void construct(Element* at) {
    ::new (static_cast<void*>(at)) Element;
  }

  bool operator==(const LargePages&) const { return true; }
};

/// A vector on huge pages, for trees with random access.
template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace ps

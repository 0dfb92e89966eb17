#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace ps {

/// Memory for large arrays. Blocks that are given back are kept, a few of them, and handed out again for the same size:
/// memory fresh from the system costs a page fault for every 4 KB, which takes longer than drawing a simple picture.
/// Safe to use from several threads.
void* take_block(std::size_t bytes);
void give_block(void* block, std::size_t bytes) noexcept;

/// Bytes that lie ready to be handed out.
std::size_t kept_block_bytes();

/// For vectors of pixels: memory from the block store. Elements made without a value are left as they are, so that
/// a picture which will be written as a whole is not written twice.
template <class T>
class BlockAllocator {
 public:
  using value_type = T;
  BlockAllocator() = default;
  template <class U>
  BlockAllocator(const BlockAllocator<U>&) {}  // NOLINT(google-explicit-constructor): allocators convert
  T* allocate(std::size_t count) { return static_cast<T*>(take_block(count * sizeof(T))); }
  void deallocate(T* block, std::size_t count) noexcept { give_block(block, count * sizeof(T)); }
  template <class U>
  void construct(U*) noexcept {
    static_assert(std::is_trivially_copyable_v<U>, "an element without a value must not need one");
  }
  template <class U, class First, class... Rest>
  void construct(U* place, First&& first, Rest&&... rest) {
    std::construct_at(place, std::forward<First>(first), std::forward<Rest>(rest)...);
  }
  template <class U>
  bool operator==(const BlockAllocator<U>&) const {
    return true;
  }
};

/// For what is made anew for each picture: resize() leaves new elements unwritten.
template <class T>
using BlockVector = std::vector<T, BlockAllocator<T>>;

}  // namespace ps

#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace ps {

/// Bytes that a value occupies: its own size and what it owns on the heap. A type that owns something has a member
/// `std::size_t heap_bytes() const`; vectors and shared pointers (each counted in full) are known here; what can be
/// copied as plain bytes owns no memory. Anything else does not compile, so no member is left out by accident.
template <class T>
std::size_t memory_size(const T& value);

namespace detail {

template <class T>
struct OwnedBytes {
  static std::size_t of(const T& value) {
    if constexpr (requires { value.heap_bytes(); }) {
      return value.heap_bytes();
    } else {
      static_assert(std::is_trivially_copyable_v<T>, "give the type a member: std::size_t heap_bytes() const");
      return 0;
    }
  }
};

template <class T, class Allocator>
struct OwnedBytes<std::vector<T, Allocator>> {
  static std::size_t of(const std::vector<T, Allocator>& values) {
    std::size_t bytes = values.capacity() * sizeof(T);
    if constexpr (!std::is_trivially_copyable_v<T>)
      for (const T& value : values) bytes += OwnedBytes<T>::of(value);
    return bytes;
  }
};

template <class T>
struct OwnedBytes<std::shared_ptr<T>> {
  static std::size_t of(const std::shared_ptr<T>& pointer) { return pointer ? memory_size(*pointer) : 0; }
};

}  // namespace detail

template <class T>
std::size_t memory_size(const T& value) {
  return sizeof(T) + detail::OwnedBytes<std::remove_const_t<T>>::of(value);
}

/// Bytes that several members own on the heap, without the members themselves: for writing heap_bytes().
template <class... T>
std::size_t owned_bytes(const T&... members) {
  return (std::size_t{0} + ... + detail::OwnedBytes<std::remove_const_t<T>>::of(members));
}

}  // namespace ps

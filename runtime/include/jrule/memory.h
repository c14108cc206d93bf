// The memory of columns: one number for each dart, in large arrays that are written as streams.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "jrule/parallel.h"

namespace jrule {

/// Allocates like std::allocator, but leaves numbers unset where none is given, so that a column is not written twice; and asks
/// for large pages where an array is large: with small ones their first touch costs more than what is written to them.
template <class T>
class ColumnAllocator {
 public:
  using value_type = T;
  ColumnAllocator() noexcept = default;
  template <class U>
  ColumnAllocator(ColumnAllocator<U> const&) noexcept {}

  T* allocate(std::size_t count);
  void deallocate(T* memory, std::size_t count) noexcept;
  template <class U, class... Args>
  void construct([[maybe_unused]] U* place, Args&&... args) {
    if constexpr (sizeof...(Args) == 0) {
      // An object of such a type begins to live with its memory.
      static_assert(std::is_trivially_copyable_v<U>);
    } else {
      std::construct_at(place, std::forward<Args>(args)...);
    }
  }
  bool operator==(ColumnAllocator const&) const noexcept { return true; }
};

/// resize() leaves the new elements unset.
template <class T>
using ColumnOf = std::vector<T, ColumnAllocator<T>>;

namespace memory {
/// Memory whose content is unset. Throws std::bad_alloc.
void* allocate(std::size_t bytes, std::size_t alignment);
void deallocate(void* memory, std::size_t bytes, std::size_t alignment) noexcept;
/// Memory whose bytes are all zero; what is never touched costs nothing. Throws std::bad_alloc.
void* allocate_zeros(std::size_t bytes);
void deallocate_zeros(void* memory, std::size_t bytes) noexcept;
}  // namespace memory

template <class T>
T* ColumnAllocator<T>::allocate(std::size_t count) {
  if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
  return static_cast<T*>(memory::allocate(count * sizeof(T), alignof(T)));
}
template <class T>
void ColumnAllocator<T>::deallocate(T* memory, std::size_t count) noexcept {
  memory::deallocate(memory, count * sizeof(T), alignof(T));
}

/// As column.reserve(capacity), strong guarantee too: what moves is copied by several threads, and so is the new memory first touched.
template <class T>
void reserve(ColumnOf<T>& column, std::size_t capacity, Threads threads) {
  if (capacity <= column.capacity()) return;
  ColumnOf<T> grown;
  grown.reserve(capacity);
  grown.resize(column.size());
  parallel::for_streams(column.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::copy(column.data() + begin, column.data() + end, grown.data() + begin);
  });
  column.swap(grown);
}

}  // namespace jrule

// A column: one number (or point, or whatever is copied as bytes) for each dart, value or index, in the order of these.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "jrule/memory.h"
#include "jrule/parallel.h"

namespace jrule {

/// As std::vector, but what resize() adds is unset, so that a column is not written twice; and a large one grows by moving its
/// pages, without a copy.
template <class T>
class ColumnOf {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;

  ColumnOf() noexcept = default;
  /// So many elements, all unset.
  explicit ColumnOf(std::size_t size) { resize(size); }
  ColumnOf(std::size_t size, T const& value) { resize(size, value); }
  ColumnOf(T const* begin, T const* end) : ColumnOf(static_cast<std::size_t>(end - begin)) { copy(begin, size_, data_); }
  ColumnOf(std::initializer_list<T> list) : ColumnOf(list.begin(), list.end()) {}
  ColumnOf(ColumnOf const& other) : ColumnOf(other.begin(), other.end()) {}
  ColumnOf(ColumnOf&& other) noexcept { swap(other); }
  ColumnOf& operator=(ColumnOf other) noexcept {
    swap(other);
    return *this;
  }
  ~ColumnOf() {
    if (data_ != nullptr) memory::deallocate(data_, bytes(capacity_), alignof(T));
  }
  void swap(ColumnOf& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data() noexcept { return data_; }
  T const* data() const noexcept { return data_; }
  std::size_t size() const noexcept { return size_; }
  std::size_t capacity() const noexcept { return capacity_; }
  bool empty() const noexcept { return size_ == 0; }
  T& operator[](std::size_t k) noexcept { return data_[k]; }
  T const& operator[](std::size_t k) const noexcept { return data_[k]; }
  T* begin() noexcept { return data_; }
  T const* begin() const noexcept { return data_; }
  T* end() noexcept { return data_ + size_; }
  T const* end() const noexcept { return data_ + size_; }
  bool operator==(ColumnOf const& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

  /// Strong guarantee. Where the elements are copied, several threads copy them, and so first touch the new memory.
  void reserve(std::size_t capacity, Threads threads = {}) {
    if (capacity <= capacity_) return;
    if (capacity > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    if (memory::has_own_pages(bytes(capacity_))) {
      data_ = static_cast<T*>(memory::grow(data_, bytes(capacity_), bytes(capacity)));
    } else {
      T* const grown = static_cast<T*>(memory::allocate(bytes(capacity), alignof(T)));
      parallel::for_streams(size_, threads, [&](std::size_t begin, std::size_t end) { copy(data_ + begin, end - begin, grown + begin); });
      if (data_ != nullptr) memory::deallocate(data_, bytes(capacity_), alignof(T));
      data_ = grown;
    }
    capacity_ = capacity;
  }
  /// Would reserve() leave the elements where they are, or move their pages?
  bool grows_without_copy(std::size_t capacity) const noexcept {
    return capacity <= capacity_ || memory::has_own_pages(bytes(capacity_));
  }
  /// What is added is unset. Needs no memory where there is room, and keeps what there is.
  void resize(std::size_t size) {
    if (size > capacity_) reserve(std::max(size, 2 * capacity_));
    size_ = size;
  }
  void resize(std::size_t size, T const& value) {
    std::size_t const before = size_;
    resize(size);
    if (size > before) std::uninitialized_fill(data_ + before, data_ + size, value);
  }
  void clear() noexcept { size_ = 0; }
  void push_back(T value) {  // a copy, for it may be one of the elements
    resize(size_ + 1);
    std::construct_at(data_ + size_ - 1, value);
  }
  void pop_back() noexcept { --size_; }

 private:
  static std::size_t bytes(std::size_t count) noexcept { return count * sizeof(T); }
  static void copy(T const* from, std::size_t count, T* to) noexcept {
    if (count != 0) std::memcpy(static_cast<void*>(to), from, bytes(count));
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace jrule

#include "jrule/memory.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace jrule::memory {

#ifdef __linux__

namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;
/// Below half a large page small ones are as good, and a large one would mostly lie idle.
constexpr std::size_t large_pages_from = large_page / 2;
/// Below that memory is better taken from the heap: what was given back there is used again without a first touch.
constexpr std::size_t own_pages_from = 8 * large_page;

/// Whole large pages, also the last one: where it were small ones, a column that grows into it would have to touch each of them.
std::size_t whole(std::size_t bytes) { return (bytes + large_page - 1) / large_page * large_page; }

/// Address space that begins at a large page.
void* map(std::size_t bytes, int protection) {
  // A large page more than is needed, of which what lies before and behind is given back.
  std::size_t const size = whole(bytes);
  if (size < bytes || size + large_page < size) throw std::bad_alloc();
  void* const mapped = mmap(nullptr, size + large_page, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  auto* const begin = static_cast<std::byte*>(mapped);
  std::size_t const before = (large_page - reinterpret_cast<std::uintptr_t>(begin) % large_page) % large_page;
  if (before != 0) (void)munmap(begin, before);
  (void)munmap(begin + before + size, large_page - before);
  return begin + before;
}

/// Zeros in pages of their own.
void* map_pages(std::size_t bytes) {
  void* const memory = map(bytes, PROT_READ | PROT_WRITE);
  // A wish, here and below: without it the memory is as good.
  (void)madvise(memory, whole(bytes), MADV_HUGEPAGE);
  return memory;
}

}  // namespace

bool has_own_pages(std::size_t bytes) noexcept { return bytes >= own_pages_from; }

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (bytes < large_pages_from) return ::operator new(bytes, std::align_val_t(alignment));
  if (has_own_pages(bytes)) return map_pages(bytes);
  void* memory = nullptr;  // not by std::aligned_alloc, which takes whole pages only
  if (posix_memalign(&memory, large_page, bytes) != 0) throw std::bad_alloc();
  // What lies behind in the last page may be given to others, who do not mind.
  (void)madvise(memory, whole(bytes), MADV_HUGEPAGE);
  return memory;
}

void deallocate(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  if (bytes < large_pages_from) return ::operator delete(memory, std::align_val_t(alignment));
  if (!has_own_pages(bytes)) return std::free(memory);
  (void)munmap(memory, whole(bytes));
}

void* grow(void* memory, std::size_t bytes, std::size_t more_bytes) {
  // To a place that begins at a large page again: otherwise the large pages would be broken into small ones to be moved.
  void* const place = map(more_bytes, PROT_NONE);
  void* const moved = mremap(memory, whole(bytes), whole(more_bytes), MREMAP_MAYMOVE | MREMAP_FIXED, place);
  // The place is not given back then: it may be free already, and somebody else's by now.
  if (moved == MAP_FAILED) throw std::bad_alloc();
  return moved;
}

void* allocate_zeros(std::size_t bytes) {
  if (bytes >= large_pages_from) return map_pages(bytes);
  if (void* const memory = std::calloc(bytes, 1)) return memory;
  throw std::bad_alloc();
}

void deallocate_zeros(void* memory, std::size_t bytes) noexcept {
  if (bytes < large_pages_from) return std::free(memory);
  (void)munmap(memory, whole(bytes));
}

#else

bool has_own_pages(std::size_t) noexcept { return false; }
void* grow(void*, std::size_t, std::size_t) { throw std::bad_alloc(); }

void* allocate(std::size_t bytes, std::size_t alignment) { return ::operator new(bytes, std::align_val_t(alignment)); }
void deallocate(void* memory, std::size_t, std::size_t alignment) noexcept { ::operator delete(memory, std::align_val_t(alignment)); }

void* allocate_zeros(std::size_t bytes) {
  if (void* const memory = std::calloc(bytes, 1)) return memory;
  throw std::bad_alloc();
}
void deallocate_zeros(void* memory, std::size_t) noexcept { std::free(memory); }

#endif

}  // namespace jrule::memory

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

/// A large page. Below half of one, small pages are as good, and a large one would mostly lie idle.
constexpr std::size_t page = std::size_t{2} << 20;
bool is_large(std::size_t bytes) { return bytes >= page / 2; }
std::size_t whole_pages(std::size_t bytes) { return (bytes + page - 1) / page * page; }

}  // namespace

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (!is_large(bytes)) return ::operator new(bytes, std::align_val_t(alignment));
  void* memory = nullptr;  // not by std::aligned_alloc, which takes whole pages only
  if (posix_memalign(&memory, page, bytes) != 0) throw std::bad_alloc();
  // A wish: without it the memory is as good. What lies behind in the last page may be given to others, who do not mind.
  (void)madvise(memory, whole_pages(bytes), MADV_HUGEPAGE);
  return memory;
}

void deallocate(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  if (!is_large(bytes)) return ::operator delete(memory, std::align_val_t(alignment));
  std::free(memory);
}

void* allocate_zeros(std::size_t bytes) {
  if (!is_large(bytes)) {
    if (void* const memory = std::calloc(bytes, 1)) return memory;
    throw std::bad_alloc();
  }
  // A page more than is needed, of which what lies outside whole large pages is given back.
  std::size_t const size = whole_pages(bytes);
  void* const mapped = mmap(nullptr, size + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  auto* const begin = static_cast<std::byte*>(mapped);
  std::size_t const before = (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
  if (before != 0) (void)munmap(begin, before);
  (void)munmap(begin + before + size, page - before);
  (void)madvise(begin + before, size, MADV_HUGEPAGE);
  return begin + before;
}

void deallocate_zeros(void* memory, std::size_t bytes) noexcept {
  if (!is_large(bytes)) return std::free(memory);
  (void)munmap(memory, whole_pages(bytes));
}

#else

void* allocate(std::size_t bytes, std::size_t alignment) { return ::operator new(bytes, std::align_val_t(alignment)); }
void deallocate(void* memory, std::size_t, std::size_t alignment) noexcept { ::operator delete(memory, std::align_val_t(alignment)); }

void* allocate_zeros(std::size_t bytes) {
  if (void* const memory = std::calloc(bytes, 1)) return memory;
  throw std::bad_alloc();
}
void deallocate_zeros(void* memory, std::size_t) noexcept { std::free(memory); }

#endif

}  // namespace jrule::memory

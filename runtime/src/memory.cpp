#include "jrule/memory.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace jrule::memory {

namespace {

#ifdef __linux__
constexpr std::size_t page = std::size_t{2} << 20;
/// Below it the C library gives memory that it has used before, whose pages are there already.
constexpr std::size_t large = std::size_t{32} << 20;
#endif

}  // namespace

void* allocate(std::size_t bytes) {
#ifdef __linux__
  if (bytes >= large) {
    std::size_t const whole = (bytes + page - 1) / page * page;
    void* const memory = std::aligned_alloc(page, whole);
    if (memory == nullptr) throw std::bad_alloc();
    (void)madvise(memory, whole, MADV_HUGEPAGE);  // a wish: without it the memory is as good
    return memory;
  }
#endif
  return ::operator new(bytes);
}

void deallocate(void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  if (bytes >= large) return std::free(memory);
#endif
  ::operator delete(memory);
}

}  // namespace jrule::memory

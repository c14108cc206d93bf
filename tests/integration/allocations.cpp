#include "tests/integration/allocations.h"

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <new>

// The linker's names: __wrap_f is called where f was, __real_f is f.
extern "C" {
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset);
void* __real_mremap(void* address, std::size_t old_size, std::size_t size, int flags, ...);
}

namespace jrule::test {

namespace {

constexpr std::size_t never = SIZE_MAX;
std::atomic<std::size_t> count = 0;
std::atomic<std::size_t> first_failing = never;
std::atomic<std::size_t> last_failing = never;

// Counts one more. Is it to fail?
bool fails() noexcept {
  std::size_t const k = ++count;
  return k >= first_failing && k <= last_failing;
}

void* take(std::size_t size) {
  if (fails()) throw std::bad_alloc();
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void* take(std::size_t size, std::align_val_t alignment) {
  if (fails()) throw std::bad_alloc();
  // It takes no alignment below a pointer's.
  void* memory = nullptr;
  if (__real_posix_memalign(&memory, std::max(static_cast<std::size_t>(alignment), sizeof(void*)), size == 0 ? 1 : size) != 0) throw std::bad_alloc();
  return memory;
}

}  // namespace

std::size_t allocation_count() noexcept { return count; }

FailingAllocation::FailingAllocation(std::size_t k, Fail how) noexcept {
  last_failing = how == Fail::once ? count + k : never;
  first_failing = count + k;
}

bool FailingAllocation::stop() noexcept {
  if (!stopped_) failed_ = count >= first_failing;
  stopped_ = true;
  first_failing = never;
  return failed_;
}

}  // namespace jrule::test

void* operator new(std::size_t size) { return jrule::test::take(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return jrule::test::take(size, alignment); }
// What gives null instead of throwing is given back by the same operators, so it is taken here too.
void* operator new(std::size_t size, std::nothrow_t const&) noexcept {
  return jrule::test::fails() ? nullptr : std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

extern "C" {
int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  return jrule::test::fails() ? ENOMEM : __real_posix_memalign(memory, alignment, size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) { return jrule::test::fails() ? nullptr : __real_calloc(count, size); }
void* __wrap_mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset) {
  if (!jrule::test::fails()) return __real_mmap(address, size, protection, flags, file, offset);
  errno = ENOMEM;
  return MAP_FAILED;
}
void* __wrap_mremap(void* address, std::size_t old_size, std::size_t size, int flags, ...) {
  va_list further;
  va_start(further, flags);
  void* const place = (flags & MREMAP_FIXED) != 0 ? va_arg(further, void*) : nullptr;
  va_end(further);
  if (!jrule::test::fails()) return __real_mremap(address, old_size, size, flags, place);
  errno = ENOMEM;
  return MAP_FAILED;
}
}

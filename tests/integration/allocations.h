// The allocations of a test program: counted, and made to fail. Its operators new are those of allocations.cpp; what the
// runtime takes without them (posix_memalign, calloc, mmap, mremap) goes there by the linker's --wrap.
#pragma once

#include <cstddef>

namespace jrule::test {

/// How many there were since the program began.
std::size_t allocation_count() noexcept;

enum class Fail { once, from_then_on };

/// While it lives, the k-th allocation fails (1: the next one), and all later ones too if so said. One at a time.
class FailingAllocation {
 public:
  FailingAllocation(std::size_t k, Fail how) noexcept;
  ~FailingAllocation() { stop(); }
  FailingAllocation(FailingAllocation const&) = delete;
  FailingAllocation& operator=(FailingAllocation const&) = delete;

  /// From now on none fails: before a test says anything, which takes memory. Did one?
  bool stop() noexcept;

 private:
  bool failed_ = false, stopped_ = false;
};

}  // namespace jrule::test

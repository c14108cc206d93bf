// By oneTBB, which only lends the threads: what is left to do they take from one counter, the calling thread with them. Chosen beside
// OpenMP and threads started for each loop, which are as good on a machine that does nothing else (OpenMP's wait awake and are
// faster on short loops), but wait for each other where other programs run: there two threads took up to hundreds of times
// as long as one. oneTBB's caller goes on alone until another thread is there.
#include "jrule/parallel.h"

#include <algorithm>
#include <exception>
#include <mutex>

#ifdef JRULE_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

// The library is not instrumented: ThreadSanitizer does not see that the threads of a loop begin after its call and end before it
// returns. Nor is this file then, and it says so itself.
#ifdef JRULE_THREAD_SANITIZER
extern "C" {
void __tsan_acquire(void* place);
void __tsan_release(void* place);
}
#endif

namespace jrule {

namespace {

#ifdef JRULE_THREAD_SANITIZER
void comes_before(void* place) noexcept { __tsan_release(place); }
void comes_after(void* place) noexcept { __tsan_acquire(place); }
#else
void comes_before(void*) noexcept {}
void comes_after(void*) noexcept {}
#endif

using Body = void (*)(void const* context, std::size_t begin, std::size_t end);

/// A loop over [0, n), cut into ranges.
class Loop {
 public:
  Loop(std::size_t n, std::size_t ranges, Body body, void const* context)
      : n_(n), size_((n + ranges - 1) / ranges), body_(body), context_(context) {}

  void run(unsigned threads) {
    comes_before(&begin_);
#ifdef JRULE_TBB
    try {
      // Isolated: a thread that waits here must not begin another task of its program meanwhile.
      tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(0U, threads, [this](unsigned) { work(); }, tbb::simple_partitioner());
      });
    } catch (...) {
      // There was no memory for a task, so no other thread has begun, or all have ended.
    }
#else
    (void)threads;
#endif
    work();
    comes_after(&end_);
    if (error_) std::rethrow_exception(error_);
  }

 private:
  /// One range after the other, until none is left.
  void work() noexcept {
    comes_after(&begin_);
    while (!failed_.load(std::memory_order_relaxed)) {
      std::size_t const begin = next_.fetch_add(1, std::memory_order_relaxed) * size_;
      if (begin >= n_) break;
      try {
        body_(context_, begin, std::min(n_, begin + size_));
      } catch (...) {
        std::lock_guard const lock(mutex_);
        if (!error_) error_ = std::current_exception();
        failed_.store(true, std::memory_order_relaxed);
      }
    }
    comes_before(&end_);
  }

  std::size_t n_, size_;
  Body body_;
  void const* context_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr error_;
  char begin_ = 0, end_ = 0;  // by their addresses ThreadSanitizer knows what comes before what
};

}  // namespace

Threads Threads::all() noexcept {
#ifdef JRULE_TBB
  return {static_cast<unsigned>(std::max(1, tbb::info::default_concurrency()))};
#else
  return {};
#endif
}

void parallel::run(std::size_t n, Threads threads, Body body, void const* context) {
  // Some ranges for each thread, so that all end at about the same time.
  std::size_t const most = n / std::max<std::size_t>(threads.grain, 1);
  std::size_t const ranges = std::min(most, std::size_t{4} * threads.count);
  if (threads.count < 2 || ranges < 2) return body(context, 0, n);
  Loop(n, ranges, body, context).run(static_cast<unsigned>(std::min<std::size_t>(threads.count, ranges)));
}

}  // namespace jrule

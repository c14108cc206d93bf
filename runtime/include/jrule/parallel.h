// Loops over indices on several threads. Which thread computes what is not said, so bodies are those whose order does not
// matter: each index writes what no other one reads or writes. Then the result is the same to the last bit for any number of
// threads.
#pragma once

#include <atomic>
#include <cstddef>

namespace jrule {

/// How many threads a call may take, the one that calls among them; never more than the machine runs at once.
struct Threads {
  unsigned count = 1;
  /// What one thread does at a time has so many indices or more: shorter loops stay on the calling thread, where they are
  /// over before another one has begun.
  std::size_t grain = 16384;

  /// As many as the machine runs at once; one if the runtime was built without oneTBB (JRULE_TBB in CMake).
  static Threads all() noexcept;
};

namespace parallel {

/// Calls `body(context, begin, end)` for ranges that together are [0, n), each once, on as many threads as are given and can be had.
/// Returns when all are done. What a body throws goes on to the caller, when no body runs any more; then some ranges may be
/// left out. Throws nothing of its own.
void run(std::size_t n, Threads threads, void (*body)(void const* context, std::size_t begin, std::size_t end), void const* context);

/// The same with a function object: `body(begin, end)`.
template <class Body>
void for_ranges(std::size_t n, Threads threads, Body const& body) {
  // Here, so that loops on one thread are compiled in their place.
  if (threads.count < 2 || n < 2 * threads.grain) return body(std::size_t{0}, n);
  run(n, threads, [](void const* context, std::size_t begin, std::size_t end) { (*static_cast<Body const*>(context))(begin, end); }, &body);
}

/// The same where little is done for each index but writing: a thread takes four times as many, since calling one costs as much.
template <class Body>
void for_streams(std::size_t n, Threads threads, Body const& body) {
  for_ranges(n, {threads.count, 4 * threads.grain}, body);
}

/// Calls `body(k)` for each k in [0, n), which must all be of the type Index.
template <class Index = std::size_t, class Body>
void for_each(std::size_t n, Threads threads, Body const& body) {
  for_ranges(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) body(static_cast<Index>(k));
  });
}

/// Is `test(k)` true for each k in [0, n)? May leave out others once it is false for one.
template <class Index = std::size_t, class Test>
bool all_of(std::size_t n, Threads threads, Test const& test) {
  std::atomic<bool> all = true;
  for_ranges(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (test(static_cast<Index>(k))) continue;
      all.store(false, std::memory_order_relaxed);
      return;
    }
  });
  return all.load(std::memory_order_relaxed);
}

}  // namespace parallel

}  // namespace jrule

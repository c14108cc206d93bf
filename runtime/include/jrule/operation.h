// What operations are run with: programs that chain rules. The interpreter and generated code use the same.
//
// An operation that fails leaves the map bit for bit as it was. The application of a rule does so by itself; where one comes after
// another, the map is copied before the first, and the copy takes its place again. Within an operation a failure is an exception, so
// that destructors undo; it never leaves the operation, whose caller gets a Result.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::operation {

/// Asked before each application of a rule and before each round of a `while`, with the number of applications so far. False cancels:
/// the operation fails with Error::Kind::cancelled. Must not change the map.
using Progress = std::function<bool(std::size_t applications)>;

/// Operations that call each other more deeply fail with Error::Kind::limit.
inline constexpr int depth_limit = 256;

struct Failure {
  Error error;
  /// Does a `try` go on with its second block? Not where the operation was cancelled, or ran out of memory or depth.
  bool is_tried() const noexcept { return error.kind == Error::Kind::not_applicable; }
};

/// What an operation and those that it calls have in common.
class Run {
 public:
  /// `name` is that of the outermost operation, which must outlive it, as `progress` must.
  Run(std::string_view name, Progress const& progress) : name_(name), progress_(progress) {}
  Run(Run const&) = delete;
  Run& operator=(Run const&) = delete;

  /// Before an application of a rule, or a round of a `while`. Throws Failure.
  void step() {
    if (progress_ && !progress_(applications_)) cancel();
  }
  /// What an application of a rule has given. Throws Failure.
  template <class T>
  T applied(Result<T>&& result) {
    if (!result) throw Failure{std::move(result).error()};
    ++applications_;
    return std::move(*result);
  }
  /// The same for applications at many orbits; `result` says at how many.
  void applied_everywhere(Result<std::size_t> const& result) {
    if (!result) throw Failure{result.error()};
    applications_ += *result;
  }
  /// How many of them there were, those too that were undone.
  std::size_t applications() const noexcept { return applications_; }

 private:
  friend class Call;
  friend class Undo;
  [[noreturn]] void cancel() const;

  std::string_view name_;
  Progress const& progress_;
  std::size_t applications_ = 0;
  int depth_ = 0;
  bool undone_ = false;  // is what is done now undone, if it fails, by what is around it?
};

/// The call of an operation, from its beginning to its end. Throws Failure.
class Call {
 public:
  Call(Run& run, std::string_view operation);
  ~Call() { --run_.depth_; }
  Call(Call const&) = delete;
  Call& operator=(Call const&) = delete;

 private:
  Run& run_;
};

/// Undoes what happens while it lives, if it is destroyed by an exception: the map becomes bit for bit what it was. May throw
/// std::bad_alloc. O(map) where it copies, both ways; else O(1).
class Undo {
 public:
  enum class Of {
    operation,  ///< copies the map, unless what is around the operation undoes it
    attempt,    ///< the first block of a `try`: copies it
    call,       ///< the first block of a `try` that needs no copy, since only its last statement changes the map
  };
  Undo(Run& run, Map& map, Of what);
  ~Undo();
  Undo(Undo const&) = delete;
  Undo& operator=(Undo const&) = delete;

 private:
  Run& run_;
  Map& map_;
  bool undone_before_;
  int exceptions_;
  std::optional<Map> saved_;
};

/// The statement `fail "message";`.
[[noreturn]] void fail(std::string_view operation, std::string_view message);
[[noreturn]] void report_dead(std::string_view operation);
/// The dart itself, if it is in the map: where the map is read. Throws Failure.
inline Dart alive(Map const& map, Dart d, std::string_view operation) {
  if (!map.contains(d)) report_dead(operation);
  return d;
}

/// A rule's copies of one node, kept beyond its next application.
class Copies {
 public:
  Copies() = default;
  /// Both by pattern dart.
  Copies(std::span<Dart const> pattern, std::span<Dart const> copies)
      : pattern_(pattern.begin(), pattern.end()), copies_(copies.begin(), copies.end()) {}
  /// `r.c[d]`: the copy for the dart `d` of the pattern. `what` is "r.c". Throws Failure. O(pattern).
  Dart at(Dart d, std::string_view operation, std::string_view what) const;

 private:
  std::vector<Dart> pattern_, copies_;
};

}  // namespace jrule::operation

#include "jrule/operation.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace jrule::operation {

static_assert(std::is_nothrow_move_assignable_v<Map>, "undoing must not fail");

namespace {

[[noreturn]] void throw_failure(Error::Kind kind, std::string message) { throw Failure{{kind, std::move(message), {}, 0}}; }

}  // namespace

void Run::cancel() const { throw_failure(Error::Kind::cancelled, fmt::format("`{}` was cancelled: the map is as it was", name_)); }

Call::Call(Run& run, std::string_view operation) : run_(run) {
  if (run_.depth_ >= depth_limit) {
    throw_failure(Error::Kind::limit, fmt::format("operations call each other more than {} deep, from `{}` down to `{}`", depth_limit, run_.name_, operation));
  }
  ++run_.depth_;
}

Undo::Undo(Run& run, Map& map, Of what)
    : run_(run), map_(map), undone_before_(run.undone_), exceptions_(std::uncaught_exceptions()) {
  if (what == Of::attempt || (what == Of::operation && !undone_before_)) saved_.emplace(map);
  if (what == Of::call) {
    run_.undone_ = false;  // up to here only: what it calls has to undo itself
  } else {
    run_.undone_ = true;
  }
}

Undo::~Undo() {
  if (saved_ && std::uncaught_exceptions() > exceptions_) map_ = std::move(*saved_);
  run_.undone_ = undone_before_;
}

void fail(std::string_view operation, std::string_view message) {
  throw_failure(Error::Kind::not_applicable, fmt::format("`{}` failed: {}", operation, message));
}

void report_dead(std::string_view operation) {
  throw_failure(Error::Kind::not_applicable, fmt::format("`{}` failed: it reads a dart that is not in the map any more", operation));
}

Dart Copies::at(Dart d, std::string_view operation, std::string_view what) const {
  auto const found = std::find(pattern_.begin(), pattern_.end(), d);
  if (found == pattern_.end()) {
    throw_failure(Error::Kind::not_applicable, fmt::format("`{}` failed: there is no `{}` for dart {}, which is not of the pattern", operation, what, d));
  }
  return copies_[static_cast<std::size_t>(found - pattern_.begin())];
}

}  // namespace jrule::operation

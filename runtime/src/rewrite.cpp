#include "jrule/rewrite.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "jrule/orbit_walk.h"

namespace jrule::rewrite {

void Workspace::reserve(std::size_t darts) {
  if (darts <= room_) return;
  // Doubling keeps a long series of applications that each add a few darts linear.
  std::size_t const room = 2 * darts, bytes = room * sizeof(std::uint32_t);
  queue_.reserve(room);
  handles_.reserve(room);
  auto* const stamps = static_cast<std::uint32_t*>(memory::allocate_zeros(bytes));
  Index* values = nullptr;
  try {
    values = static_cast<Index*>(memory::allocate_zeros(bytes));
  } catch (...) {
    memory::deallocate_zeros(stamps, bytes);
    throw;
  }
  Workspace grown;
  grown.stamp_ = std::exchange(stamp_, stamps);
  grown.value_ = std::exchange(value_, values);
  grown.room_ = std::exchange(room_, room);
  epoch_ = 1;
}

Workspace::~Workspace() {
  std::size_t const bytes = room_ * sizeof(std::uint32_t);
  if (room_ == 0) return;
  memory::deallocate_zeros(stamp_, bytes);
  memory::deallocate_zeros(value_, bytes);
}

void Workspace::swap(Workspace& other) noexcept {
  std::swap(stamp_, other.stamp_);
  std::swap(value_, other.value_);
  std::swap(room_, other.room_);
  std::swap(epoch_, other.epoch_);
  queue_.swap(other.queue_);
  handles_.swap(other.handles_);
  pattern_.swap(other.pattern_);
  columns_.swap(other.columns_);
  std::swap(used_, other.used_);
}

Index* Workspace::column(std::size_t size) {
  if (used_ == columns_.size()) columns_.emplace_back();
  ColumnOf<Index>& column = columns_[used_++];
  if (column.size() < size) {
    // Nothing of it is kept.
    column.clear();
    column.resize(std::max(size, 2 * column.capacity()));
  }
  return column.data();
}

void Workspace::clear_marks() noexcept {
  if (++epoch_ == 0) {
    std::fill(stamp_, stamp_ + room_, 0);
    epoch_ = 1;
  }
}

std::vector<Dart> close_pattern(Map const& map, Dart hook, std::span<Word const> words, Workspace& workspace) {
  workspace.begin();
  workspace.reserve(map.dart_limit());
  workspace.clear_marks();
  workspace.meet(hook);
  for (std::size_t k = 0; k < workspace.pattern().size(); ++k) {
    Dart const d = workspace.pattern()[k];
    for (Word const& word : words) {
      workspace.meet(map.walk(d, word));
      workspace.meet(map.walk_back(d, word));
    }
  }
  return workspace.pattern();
}

Column column(Map const& map, std::vector<Dart> const& pattern, Word const& word, Workspace const& workspace, Threads threads) {
  Column result(pattern.size());
  parallel::for_each(pattern.size(), threads, [&](std::size_t k) { result[k] = workspace.value(map.walk(pattern[k], word)); });
  return result;
}

std::span<Dart const> walk_in_step(Map const& map, Dart hook, std::size_t pattern_size, std::span<Loop const> loops, Workspace& workspace) {
  Dart* const match = workspace.column(pattern_size);
  Index* const queue = workspace.column(pattern_size);
  std::fill(match, match + pattern_size, no_dart);
  match[0] = hook;
  queue[0] = 0;
  std::size_t met = 1;
  // Columns are permutations, so following them forwards from 0 reaches all that can be reached.
  for (std::size_t next = 0; next < met; ++next) {
    Index const k = queue[next];
    for (Loop const& loop : loops) {
      Index const to = loop.word[k];
      if (match[to] != no_dart) continue;
      match[to] = map.target(match[k], loop.dimension);
      queue[met++] = to;
    }
  }
  if (met != pattern_size) return {};
  return {match, pattern_size};
}

std::optional<Dart> matched_twice(std::span<std::span<Dart const> const> matches, Workspace& workspace) {
  workspace.clear_marks();
  for (std::span<Dart const> const match : matches) {
    for (Dart const d : match) {
      if (!workspace.mark(d, 0)) return d;
    }
  }
  return {};
}

namespace {

/// Two arms that grow from the hook in turns, a dart at a time, as close_pattern() meets them: how far they come, and their tips.
struct Arms {
  std::size_t length[2] = {0, 0};
  Dart tip[2];
  bool closed = false;  // do they meet?

  /// The place in P of the i-th dart of an arm; the hook is the 0-th of both.
  Index place(int arm, std::size_t i) const noexcept {
    if (i == 0) return 0;
    return static_cast<Index>(arm == 0 ? i + std::min(i - 1, length[1]) : i + std::min(i, length[0]));
  }
  Index tip_place(int arm) const noexcept { return place(arm, length[arm]); }
};

}  // namespace

LinePattern dihedral_pattern(Dart const* first, Dart const* second, Dart hook, Workspace& workspace) {
  Arms arms{.tip = {hook, hook}};
  Dart const* const ways[2] = {first, second};
  bool open[2] = {true, true};
  workspace.append(hook);
  while (!arms.closed && (open[0] || open[1])) {
    for (int const arm : {0, 1}) {
      if (!open[arm]) continue;
      Dart const to = ways[(static_cast<std::size_t>(arm) + arms.length[arm]) % 2][arms.tip[arm]];  // the dimensions take turns
      open[arm] = to != arms.tip[arm];
      arms.closed = open[arm] && to == arms.tip[1 - arm];
      if (arms.closed) break;
      if (!open[arm]) continue;
      workspace.append(to);
      arms.tip[arm] = to;
      ++arms.length[arm];
    }
  }
  std::vector<Dart> const& darts = workspace.pattern();
  Index* const columns[2] = {workspace.column(darts.size()), workspace.column(darts.size())};
  auto const link = [&](std::size_t way, Index from, Index to) {
    columns[way % 2][from] = to;
    columns[way % 2][to] = from;
  };
  for (int const arm : {0, 1}) {
    auto const way = static_cast<std::size_t>(arm);
    for (std::size_t i = 0; i < arms.length[arm]; ++i) link(way + i, arms.place(arm, i), arms.place(arm, i + 1));
    link(way + arms.length[arm], arms.tip_place(arm), arms.tip_place(arms.closed ? 1 - arm : arm));
  }
  return {darts, columns[0], columns[1]};
}

LinePattern cycle_pattern(Dart const* forwards, Dart const* backwards, Dart hook, Workspace& workspace) {
  Arms arms{.tip = {hook, hook}};
  Dart const* const ways[2] = {forwards, backwards};
  workspace.append(hook);
  while (!arms.closed) {
    for (int const arm : {0, 1}) {
      Dart const to = ways[arm][arms.tip[arm]];
      arms.closed = to == arms.tip[1 - arm];
      if (arms.closed) break;
      workspace.append(to);
      arms.tip[arm] = to;
      ++arms.length[arm];
    }
  }
  std::vector<Dart> const& darts = workspace.pattern();
  Index *const next = workspace.column(darts.size()), *const last = workspace.column(darts.size());
  auto const link = [&](Index from, Index to) {
    next[from] = to;
    last[to] = from;
  };
  for (std::size_t i = 0; i < arms.length[0]; ++i) link(arms.place(0, i), arms.place(0, i + 1));
  for (std::size_t i = 0; i < arms.length[1]; ++i) link(arms.place(1, i + 1), arms.place(1, i));
  link(arms.tip_place(0), arms.tip_place(1));
  return {darts, next, last};
}

void PatternOrbits::fill(Index* numbers, Index k, Index number) const noexcept {
  numbers[k] = number;
  std::size_t open = 0;
  open_[open++] = k;
  while (open != 0) {
    Index const from = open_[--open];
    for (Index const* const column : columns_) {
      Index const to = column[from];
      if (numbers[to] != unset) continue;
      numbers[to] = number;
      open_[open++] = to;
    }
  }
}

Result<std::size_t> apply_everywhere(Map const& map, OrbitType const& type, std::function<Result<void>(Dart)> const& apply) {
  std::vector<Dart> const starts = number_orbits(map, type).first;
  std::size_t count = 0;
  std::optional<Error> first_refusal;
  for (Dart const d : starts) {
    if (!map.contains(d)) continue;  // deleted by an earlier application
    Result<void> const applied = apply(d);
    if (applied) {
      ++count;
    } else if (applied.error().kind != Error::Kind::not_applicable) {
      return tl::unexpected(applied.error());
    } else if (!first_refusal) {
      first_refusal = applied.error();
    }
  }
  if (count == 0 && first_refusal) return tl::unexpected(*first_refusal);
  return count;
}

Result<void> check_modeler(Map const& map, Model const& model, std::vector<EmbeddingSpec> const& embeddings) {
  if (map.model() != model) {
    return fail(Error::Kind::bad_input, fmt::format("the map is of the model {}({}), not {}({})", map.model().name, map.model().dimension, model.name, model.dimension));
  }
  for (std::size_t e = 0; e < embeddings.size(); ++e) {
    if (e >= map.embedding_count() || map.embedding(e).spec() != embeddings[e]) {
      return fail(Error::Kind::bad_input, fmt::format("embedding {} of the map is not `{}` as its modeler declares it", e, embeddings[e].name));
    }
  }
  if (map.embedding_count() != embeddings.size()) {
    return fail(Error::Kind::bad_input, fmt::format("the map has {} embeddings, its modeler declares {}", map.embedding_count(), embeddings.size()));
  }
  return {};
}

Result<Map> expect_modeler(Map map, Model const& model, std::vector<EmbeddingSpec> const& embeddings) {
  if (auto const checked = check_modeler(map, model, embeddings); !checked) return tl::unexpected(checked.error());
  return map;
}

namespace {
Error not_applicable(std::string message) { return {Error::Kind::not_applicable, std::move(message), {}, 0}; }
}  // namespace

Error not_a_dart(std::string_view rule, std::string_view hook, Dart d) {
  return not_applicable(fmt::format("`{}` is not applicable: the map has no dart {} to be matched by the hook `{}`", rule, d, hook));
}

Error arc_differs(std::string_view rule, std::string_view source, int dimension, std::string_view target, Dart at, Dart leads_to,
                  Dart expected) {
  if (at == expected) {
    return not_applicable(fmt::format("`{}` is not applicable: the {}-arc of `{}` has to be a loop, but from dart {} it leads to dart {}", rule,
                                      dimension, source, at, leads_to));
  }
  return not_applicable(fmt::format("`{}` is not applicable: the {}-arc of `{}` has to lead to `{}`, but from dart {} it leads to dart {}, not {}",
                                    rule, dimension, source, target, at, leads_to, expected));
}

Error matched_twice_error(std::string_view rule, Dart d) {
  return not_applicable(fmt::format("`{}` is not applicable: dart {} would be matched twice", rule, d));
}

Error hook_not_determined(std::string_view rule, std::string_view hook) {
  return not_applicable(fmt::format("`{}` is not applicable: the orbit of the hook `{}` does not determine its whole copy of the pattern", rule, hook));
}

Error requirement_failed(std::string_view rule, std::string_view condition, std::vector<HookDart> const& hooks) {
  std::string message = fmt::format("`{}` is not applicable: `{}` does not hold", rule, condition);
  for (HookDart const& h : hooks) {
    std::string_view const before = &h == &hooks.front() ? " where" : &h == &hooks.back() ? " and" : ",";
    message += fmt::format("{} the hook `{}` is dart {}", before, h.hook, h.dart);
  }
  return not_applicable(std::move(message));
}

Error no_memory(std::string_view rule) noexcept {
  Error error{Error::Kind::no_memory, {}, {}, 0};
  try {
    error.message = fmt::format("`{}` is not applied: there is not enough memory for its result", rule);
  } catch (std::bad_alloc const&) {
    // Not even for that. So short a text takes none.
    error.message = "out of memory";
  }
  return error;
}

}  // namespace jrule::rewrite

// How the values of an embedding are stored and dropped: three candidates, each as small as it can be, on the vertices
// of a torus of 1000 x 1000 quads (8 million darts, a Point3 for each vertex).
//
// Chosen: Swept, which is what embedding.h does. CPU time and bytes, beside those of Swept:
//
//                                       Counted     Inline
//   create, memory at hand                1.5         2.3      page faults included: 3 and 10
//   change_all                            0.8         0.95     both then hold twice the values, old and new
//   change_one                            1.4         0.4
//   split                                 1.1         3.5
//   read_faces, new                       1           2.9
//   read_faces, all changed at random     1           0.4
//   bytes, new                            1.07        3.4      7.1 bytes a dart for Swept; the arcs are 12 more
//   bytes, changed one by one             0.7         2.1      11.3 bytes a dart
//
// Inline wins only where single vertices are changed or read without order, and needs more memory than all the rest of
// a map. Counted drops at once, never looks at all darts and is the smallest after single changes; but it makes a
// random access for each handle that is written, which for single changes costs more than the sweeps, and leaves holes
// in the pool, where values with destructors would need a flag. What speaks against Swept is the pause: the sweep that
// comes once in 900 000 single changes takes as long as some 50 000 of them in a real map (rewrite::set_value), so a
// twentieth of their time. Renumbering in the order of the darts instead of the pool made reading a map that was
// changed at random a third faster, as it stands between two sweeps, but the sweep took five times as long.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "jrule/map.h"

namespace {

using jrule::Dart;
using jrule::Handle;
using jrule::no_handle;
using jrule::Point3;

constexpr std::uint32_t side = 1000;
constexpr std::uint32_t vertices = side * side;
constexpr std::uint32_t darts = 8 * vertices;

template <class T>
std::size_t bytes(std::vector<T> const& v) {
  return v.capacity() * sizeof(T);
}

/// A handle per dart, for each value the number of its darts, and a list of free places. Dropped at once.
class Counted {
 public:
  using Given = Handle;
  explicit Counted(std::size_t count) : handles_(count, no_handle) {}
  Handle add(Point3 const& value) {
    if (free_.empty()) {
      values_.push_back(value);
      counts_.push_back(0);
      return static_cast<Handle>(values_.size() - 1);
    }
    Handle const h = free_.back();
    free_.pop_back();
    values_[h] = value;
    return h;
  }
  void give(Dart d, Handle h) {
    Handle const old = std::exchange(handles_[d], h);
    ++counts_[h];
    if (old != no_handle && --counts_[old] == 0) free_.push_back(old);
  }
  void copy(Dart from, Dart to) { give(to, handles_[from]); }
  void end_application() {}
  Point3 const& operator[](Dart d) const { return values_[handles_[d]]; }
  std::size_t size() const { return bytes(handles_) + bytes(values_) + bytes(counts_) + bytes(free_); }

 private:
  std::vector<Handle> handles_;
  std::vector<Point3> values_;
  std::vector<std::uint32_t> counts_;
  std::vector<Handle> free_;
};

/// A handle per dart. When as many handles have been overwritten and values added as there are darts, what no dart has
/// is dropped, and the rest moves up.
class Swept {
 public:
  using Given = Handle;
  explicit Swept(std::size_t count) : handles_(count, no_handle) {}
  Handle add(Point3 const& value) {
    values_.push_back(value);
    return static_cast<Handle>(values_.size() - 1);
  }
  void give(Dart d, Handle h) {
    if (std::exchange(handles_[d], h) != no_handle) ++overwritten_;
  }
  void copy(Dart from, Dart to) { give(to, handles_[from]); }
  void end_application() {
    if (overwritten_ + values_.size() - kept_ >= handles_.size()) sweep();
  }
  void sweep() {
    renumbered_.assign(values_.size(), no_handle);
    for (Handle const h : handles_) {
      if (h != no_handle) renumbered_[h] = 0;
    }
    overwritten_ = kept_ = 0;
    for (std::size_t h = 0; h < values_.size(); ++h) {
      if (renumbered_[h] == no_handle) continue;
      values_[kept_] = values_[h];
      renumbered_[h] = static_cast<Handle>(kept_++);
    }
    for (Handle& h : handles_) {
      if (h != no_handle) h = renumbered_[h];
    }
    values_.resize(kept_);
  }
  Point3 const& operator[](Dart d) const { return values_[handles_[d]]; }
  std::size_t size() const { return bytes(handles_) + bytes(values_) + bytes(renumbered_); }

 private:
  std::vector<Handle> handles_;
  std::vector<Point3> values_;
  std::vector<Handle> renumbered_;
  std::size_t overwritten_ = 0, kept_ = 0;
};

/// The value itself at each dart. Nothing to drop.
class Inline {
 public:
  using Given = Point3;
  explicit Inline(std::size_t count) : values_(count) {}
  Point3 add(Point3 const& value) { return value; }
  void give(Dart d, Point3 const& value) { values_[d] = value; }
  void copy(Dart from, Dart to) { values_[to] = values_[from]; }
  void end_application() {}
  Point3 const& operator[](Dart d) const { return values_[d]; }
  std::size_t size() const { return bytes(values_); }

 private:
  std::vector<Point3> values_;
};

/// Gives the vertex at (x, y), eight darts in four faces, its value. Darts 2k and 2k + 1 of a face are the ends of its
/// side k.
template <class Store>
void give_vertex(Store& store, std::uint32_t x, std::uint32_t y, typename Store::Given const& given) {
  std::uint32_t const left = (x + side - 1) % side, below = (y + side - 1) % side;
  std::uint32_t const face[] = {y * side + x, y * side + left, below * side + left, below * side + x};
  for (std::uint32_t k = 0; k < 4; ++k) {
    store.give(8 * face[k] + (2 * k + 7) % 8, given);
    store.give(8 * face[k] + 2 * k, given);
  }
}

/// One application at every vertex. All new values are there before an old one may go: the application may still fail.
template <class Store>
void set_all(Store& store, double z) {
  std::vector<typename Store::Given> given;
  given.reserve(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) given.push_back(store.add({double(v % side), double(v / side), z}));
  for (std::uint32_t v = 0; v < vertices; ++v) give_vertex(store, v % side, v / side, given[v]);
  store.end_application();
}

/// One application at a random vertex.
template <class Store>
void set_one(Store& store, std::minstd_rand& random) {
  std::uint32_t const x = static_cast<std::uint32_t>(random()) % side, y = static_cast<std::uint32_t>(random()) % side;
  give_vertex(store, x, y, store.add({double(x), double(y), 1}));
  store.end_application();
}

template <class Store>
void report(benchmark::State& state, Store const& store, std::uint32_t items, std::uint32_t of_darts = darts) {
  state.SetItemsProcessed(state.iterations() * items);
  state.counters["bytes_per_dart"] = double(store.size()) / of_darts;
}

/// A new map, every vertex of which gets a value.
template <class Store>
void create(benchmark::State& state) {
  Store last(0);
  for (auto _ : state) {
    Store store(darts);
    set_all(store, 0);
    last = std::move(store);
  }
  report(state, last, vertices);
}

/// Every vertex gets a new value instead of its old one, in one application.
template <class Store>
void change_all(benchmark::State& state) {
  Store store(darts);
  set_all(store, 0);
  for (auto _ : state) set_all(store, 1);
  report(state, store, vertices);
}

/// A vertex gets a new value; each item is an application, at a random place. Long enough for the sweeps to count.
template <class Store>
void change_one(benchmark::State& state) {
  Store store(darts);
  set_all(store, 0);
  std::minstd_rand random(1);
  for (auto _ : state) {
    for (std::uint32_t i = 0; i < vertices; ++i) set_one(store, random);
  }
  report(state, store, vertices);
}

/// As many darts again get the values of their neighbours: what an orbit that is split does.
template <class Store>
void split(benchmark::State& state) {
  Store last(0);
  for (auto _ : state) {
    state.PauseTiming();
    Store store(2 * darts);
    set_all(store, 0);
    state.ResumeTiming();
    for (Dart d = 0; d < darts; ++d) store.copy(d, darts + d);
    store.end_application();
    state.PauseTiming();
    last = std::move(store);
    state.ResumeTiming();
  }
  report(state, last, darts, 2 * darts);
}

/// The mean over each face; `range`: how many values per vertex were changed before, one by one.
template <class Store>
void read_faces(benchmark::State& state) {
  Store store(darts);
  set_all(store, 0);
  std::minstd_rand random(1);
  for (std::int64_t i = 0; i < state.range(0) * vertices; ++i) set_one(store, random);
  for (auto _ : state) {
    for (Dart d = 0; d < darts; d += 8) {
      Point3 const &a = store[d], &b = store[d + 2], &c = store[d + 4], &e = store[d + 6];
      Point3 const sum{a.x + b.x + c.x + e.x, a.y + b.y + c.y + e.y, a.z + b.z + c.z + e.z};
      benchmark::DoNotOptimize(Point3{sum.x / 4, sum.y / 4, sum.z / 4});
    }
  }
  report(state, store, vertices);
}

/// The longest that one application waits: a sweep after as many changes as bring it about.
void pause_of_swept(benchmark::State& state) {
  Swept store(darts);
  std::minstd_rand random(1);
  set_all(store, 0);
  for (auto _ : state) {
    state.PauseTiming();
    // Eight handles are overwritten and one value is added for each.
    for (std::uint32_t i = 0; i < darts / 9; ++i) set_one(store, random);
    state.ResumeTiming();
    store.sweep();
  }
  report(state, store, vertices);
}

}  // namespace

#define JRULE_STORAGES(workload)                                      \
  BENCHMARK(workload<Counted>)->Unit(benchmark::kMillisecond);        \
  BENCHMARK(workload<Swept>)->Unit(benchmark::kMillisecond);          \
  BENCHMARK(workload<Inline>)->Unit(benchmark::kMillisecond)
JRULE_STORAGES(create);
JRULE_STORAGES(change_all);
JRULE_STORAGES(change_one);
JRULE_STORAGES(split);
#undef JRULE_STORAGES
BENCHMARK(read_faces<Counted>)->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(read_faces<Swept>)->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(read_faces<Inline>)->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(pause_of_swept)->Unit(benchmark::kMillisecond);

// Embeddings whose values are of a C++ type that the runtime does not know, and merging on trial.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "jrule/trial.h"
#include "jrule/typed.h"

namespace jrule::rewrite {
namespace {

EmbeddingSpec names() {
  EmbeddingSpec spec{"name", orbit_of_dimensions({0, 1}), Type::Extern};
  spec.extern_name = "std::string";
  spec.extern_parts.make_pool = &make_pool<std::string>;
  return spec;
}

// Merged by joining them; "!" is refused.
EmbeddingSpec joined_names() {
  EmbeddingSpec spec = names();
  spec.merge = MergePolicy::function;
  spec.extern_parts.add_merged = [](Embedding& embedding, std::span<Handle const> parts) {
    return add_folded<std::string>(embedding, parts, [](std::string const& a, std::string const& b) {
      if (b == "!") throw std::domain_error("!");
      return a + b;
    });
  };
  return spec;
}

TEST(ExternEmbedding, NeedsItsPool) {
  EmbeddingSpec spec = names();
  spec.extern_parts.make_pool = nullptr;
  EXPECT_THROW(Embedding{spec}, std::invalid_argument);
  spec = names();
  spec.extern_name.clear();
  EXPECT_THROW(Embedding{spec}, std::invalid_argument);
  spec = names();
  spec.type = Type::Real;
  EXPECT_THROW(Embedding{spec}, std::invalid_argument);
}

TEST(ExternEmbedding, NeedsItsMergeFunction) {
  EmbeddingSpec spec = joined_names();
  EXPECT_NO_THROW(Embedding{spec});
  spec.extern_parts.add_merged = nullptr;
  EXPECT_THROW(Embedding{spec}, std::invalid_argument);
  spec = names();
  for (MergePolicy const policy : {MergePolicy::mean, MergePolicy::min, MergePolicy::max}) {
    spec.merge = policy;
    EXPECT_THROW(Embedding{spec}, std::invalid_argument);
  }
  spec.merge = MergePolicy::first;
  EXPECT_NO_THROW(Embedding{spec});
}

TEST(ExternEmbedding, KeepsCopiesAndDropsValues) {
  Embedding e(names());
  EXPECT_EQ(add<std::string>(e, "a"), 0U);
  EXPECT_EQ(add<std::string>(e, "b"), 1U);
  EXPECT_EQ(add<std::string>(e, "c"), 2U);
  EXPECT_THROW(e.add(Value(0.5)), std::invalid_argument);
  EXPECT_FALSE(e.add_default());
  e.resize(3);
  e.set_handle(0, 2);
  e.set_handle(2, 0);
  Embedding copy = e;
  copy.compact();
  EXPECT_EQ(copy.values<std::string>(), (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(copy.handle(0), 1U);
  EXPECT_EQ(copy.handle(1), no_handle);
  EXPECT_EQ(copy.handle(2), 0U);
  EXPECT_EQ(e.value_count(), 3U);
  e.truncate_values(1);
  EXPECT_EQ(e.values<std::string>(), std::vector<std::string>{"a"});
  e = copy;
  EXPECT_EQ(e.value_count(), 2U);
  e.reserve_values(100);
  std::string const* const first = e.values<std::string>().data();
  for (int i = 0; i < 100; ++i) (void)add<std::string>(e, "x");
  EXPECT_EQ(e.values<std::string>().data(), first);
}

// A type from outside may be another name of one of the language's.
TEST(ExternEmbedding, HoldsTypesOfTheLanguageToo) {
  EmbeddingSpec spec = names();
  spec.extern_name = "flag";
  spec.extern_parts.make_pool = &make_pool<bool>;
  Embedding e(spec);
  (void)add<bool>(e, true);
  EXPECT_EQ(e.values<std::uint8_t>().size(), 1U);
}

TEST(ExternEmbedding, ValuesAreNotCompared) {
  Map map(gmap(2), {names()});
  map.add_darts(2);
  map.link(0, 0, 1);
  Embedding& e = map.embedding(0);
  e.set_handle(0, add<std::string>(e, "a"));
  e.set_handle(1, add<std::string>(e, "a"));
  auto const violation = find_violation(map);
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->kind, Violation::Kind::embedding);
  e.set_handle(1, 0);
  EXPECT_FALSE(find_violation(map));
}

// ---- Trials ----

// Four darts of a 2-O-map, each a face of one side, with the names a b c and "!".
Map four_faces() {
  EmbeddingSpec spec = joined_names();
  spec.orbit = orbit_of_dimensions({1});
  Map map(omap(2), {spec});
  map.add_darts(4);
  Embedding& e = map.embedding(0);
  std::string const texts[] = {"a", "b", "c", "!"};
  for (Dart d = 0; d < 4; ++d) e.set_handle(d, add<std::string>(e, texts[d]));
  return map;
}

TEST(Trial, MergesByTheFunction) {
  Map map = four_faces();
  Workspace workspace;
  workspace.reserve(4);
  Trial trial(map, workspace, 2);
  trial.set_target(0, 1, 1);
  trial.set_target(1, 1, 0);
  trial.begin_merges(0);
  for (Dart const d : {0U, 1U, 2U}) trial.merge(d);
  trial.keep();
  EXPECT_EQ(map.embedding(0).handle(0), 0U);  // not yet
  trial.commit_merges(0);
  EXPECT_EQ(map.embedding(0).handle(0), 4U);
  EXPECT_EQ(map.embedding(0).handle(1), 4U);
  EXPECT_EQ(map.embedding(0).handle(2), 2U);
  EXPECT_EQ(map.embedding(0).values<std::string>()[4], "ab");
}

TEST(Trial, LeavesExcludedOrbitsAlone) {
  Map map = four_faces();
  Workspace workspace;
  workspace.reserve(4);
  Trial trial(map, workspace, 2);
  trial.set_target(0, 1, 3);
  trial.set_target(3, 1, 0);
  trial.begin_merges(0);
  trial.exclude(3);
  EXPECT_NO_THROW(trial.merge(0));
  trial.keep();
  trial.commit_merges(0);
  EXPECT_EQ(map.embedding(0).value_count(), 4U);
}

// The face 0 1 2 3 loses the dart 1, which is to be deleted, and gets a new one instead: the source of 2 is no target
// that is written.
TEST(Trial, IsUndoneUnlessKept) {
  Map map = four_faces();
  for (Dart d = 0; d < 4; ++d) map.set_target(d, 1, (d + 1) % 4);
  map.add_darts(2);
  map.erase(4);
  Workspace workspace;
  workspace.reserve(8);
  {
    Trial trial(map, workspace, 3);
    std::span<Dart const> const added = trial.add_darts(2);
    EXPECT_EQ(std::vector<Dart>(added.begin(), added.end()), (std::vector<Dart>{4, 6}));
    trial.set_target(0, 1, 4);
    trial.set_target(4, 1, 6);
    trial.set_target(6, 1, 2);
    EXPECT_EQ(map.source(2, 1), 6U);
    trial.begin_merges(0);
    EXPECT_THROW(trial.merge(0), std::domain_error);
  }
  EXPECT_EQ(map.dart_limit(), 6U);
  EXPECT_EQ(map.dart_count(), 5U);
  for (Dart d = 0; d < 4; ++d) {
    EXPECT_EQ(map.target(d, 1), (d + 1) % 4);
    EXPECT_EQ(map.source((d + 1) % 4, 1), d);
    EXPECT_EQ(map.embedding(0).handle(d), d);
  }
  EXPECT_EQ(map.embedding(0).value_count(), 4U);
  EXPECT_EQ(map.add_darts(2), (std::vector<Dart>{4, 6}));
}

}  // namespace
}  // namespace jrule::rewrite

// Random operations: the interpreter against generated C++. The same results, messages and questions to the caller, and the same darts, arcs
// and values; where they fail or are cancelled, the map before, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/backend/cpp/emit.h"
#include "tests/process/process.h"
#include "tests/property/cases.h"
#include "tests/property/generated_code.h"
#include "tests/property/random_operations.h"
#include "tests/unit/operation_fixture.h"

namespace jrule::property {

namespace {

using Generated = Result<std::int64_t> (*)(Map& map, Dart d, std::int64_t n, operation::Progress const& progress);

// The program's operations as C++, compiled and loaded.
std::vector<Generated> compile(tests::Operations const& s, std::string const& name) {
  std::filesystem::path const folder = make_folder(name);
  ir::Program program = s.program;
  program.module = name;
  std::vector<cpp::Rule> rules;
  for (std::size_t i = 0; i < program.rules.size(); ++i) rules.push_back({&program.rules[i], &s.verdicts[i].plan});
  source::Sources sources;
  sources.add("random.jrule", "");
  source::Diagnostics diagnostics;
  for (auto const& file : cpp::emit(program, rules, sources, {name, {}}, diagnostics)) tests::write(folder / file.name, file.text);
  for (source::Diagnostic const& d : diagnostics.all()) throw std::runtime_error("emit: " + d.message);
  std::string text = "#include \"" + name + ".cpp\"\n" + R"(
using Function = jrule::Result<std::int64_t> (*)(jrule::Map&, jrule::Dart, std::int64_t, jrule::operation::Progress const&);
template <class Modeler, auto function>
jrule::Result<std::int64_t> call(jrule::Map& map, jrule::Dart d, std::int64_t n, jrule::operation::Progress const& progress) {
  auto modeler = Modeler::from_map(map);
  if (!modeler) return tl::unexpected(modeler.error());
  auto result = function(*modeler, d, n, progress);
  map = std::move(modeler->map());
  return result;
}
extern "C" {
extern Function const jrule_operations[];
Function const jrule_operations[] = {
)";
  for (ir::Operation const& o : program.operations) text += fmt::format("  call<{0}::S, {0}::{1}>,\n", name, o.name);
  tests::write(folder / "operations.cpp", text + "};\n}\n");
  auto const* table = static_cast<Generated const*>(load(folder, "operations.cpp", "jrule_operations"));
  return {table, table + program.operations.size()};
}

/// Darts, arcs and values by dart; when values that no dart has any more are dropped is each one's own.
std::string content(Map const& map) {
  std::string text = fmt::format("limit {}\n", map.dart_limit());
  for (Dart const d : map.darts()) {
    text += fmt::format("{}:", d);
    for (int const i : map.model().dimensions) text += fmt::format(" {}", map.target(d, i));
    for (std::size_t e = 0; e < map.embedding_count(); ++e) text += fmt::format(" {}", to_string(map.embedding(e).value(map.embedding(e).handle(d))));
    text += '\n';
  }
  return text;
}

struct Outcome {
  std::string result, map;
  std::vector<std::size_t> asked;
  bool failed = false, kept = false;  ///< is it the map before, bit for bit?
  bool operator==(Outcome const& o) const { return result == o.result && map == o.map && asked == o.asked; }
};
void PrintTo(Outcome const& o, std::ostream* out) { *out << o.result << "\nasked " << o.asked.size() << " times\n" << o.map; }

// `run` on a copy of the map, cancelled at the `limit`th question.
template <class Run>
Outcome outcome(Map const& start, std::size_t limit, Run run) {
  Map map = start;
  Outcome o;
  auto const result = run(map, [&](std::size_t applications) {
    o.asked.push_back(applications);
    return o.asked.size() < limit;
  });
  o.result = result ? fmt::format("{}", *result) : fmt::format("{} {}", static_cast<int>(result.error().kind), result.error().message);
  o.map = content(map);
  o.failed = !result;
  o.kept = tests::bits(map) == tests::bits(start);
  return o;
}

TEST(GeneratedOperations, DoWhatTheInterpreterDoes) {
  std::size_t const count = static_cast<std::size_t>(std::max(30, case_count() / 125));
  constexpr std::size_t batch = 30;
  std::size_t done = 0, failed = 0, cancelled = 0;
  Random random(case_seed());
  for (std::size_t begin = 0; begin < count; begin += batch) {
    std::string const text = random_operations(batch, random);
    tests::Operations s(text);
    std::vector<Generated> const generated = compile(s, fmt::format("random_operations_{}", begin / batch));
    // Maps to start from: what some of them leave.
    std::vector<Map> starts;
    for (int triangles = 1; triangles <= 3; ++triangles) {
      Map map = s.empty();
      rewrite::Workspace workspace;
      for (int t = 0; t < triangles; ++t) {
        ASSERT_TRUE(interpreter::apply(s.program.rules[0], s.verdicts[0].plan, map, {}, {Value{1.5 * t}}, workspace));
      }
      starts.push_back(std::move(map));
    }
    for (std::size_t i = 0; i < batch; ++i) {
      for (int round = 0; round < 6; ++round) {
        Map const start = random.pick(starts);
        Dart const d = random.pick(start.darts());
        auto const n = static_cast<std::int64_t>(random.below(5));
        std::size_t const limit = random.chance(25) ? random.between(1, 8) : 5000;
        Outcome const expected = outcome(start, limit, [&](Map& map, operation::Progress const& progress) -> Result<std::int64_t> {
          auto const result = s.run("f" + std::to_string(i), map, {d, Value{n}}, progress);
          if (!result) return tl::unexpected(result.error());
          return std::get<std::int64_t>(std::get<Value>(result->value()));
        });
        Outcome const found =
            outcome(start, limit, [&](Map& map, operation::Progress const& progress) { return generated[i](map, d, n, progress); });
        ASSERT_EQ(found, expected) << "f" << i << "(" << d << ", " << n << ") of\n" << text << "on\n" << tests::bits(start);
        bool const good = !expected.failed;
        for (Outcome const* o : {&expected, &found}) {
          ASSERT_TRUE(!o->failed || o->kept) << "f" << i << "(" << d << ", " << n << ") failed, " << o->result << ", of\n" << text;
        }
        ++(good ? done : expected.asked.size() >= limit ? cancelled : failed);
        if (good && start.dart_count() < 40) starts[random.below(starts.size())] = [&] {
          Map map = start;
          (void)s.run("f" + std::to_string(i), map, {d, Value{n}});
          return map.dart_count() > 0 && map.dart_count() < 80 ? map : start;
        }();
      }
    }
  }
  RecordProperty("done", std::to_string(done));
  RecordProperty("failed", std::to_string(failed));
  RecordProperty("cancelled", std::to_string(cancelled));
  EXPECT_GE(done, count);
  EXPECT_GE(failed, count);
  EXPECT_GE(cancelled, count / 10);
}

}  // namespace

}  // namespace jrule::property

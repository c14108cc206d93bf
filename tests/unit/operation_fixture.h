// Operations from text, run by the interpreter; and maps compared with all that they hold.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "compiler/analysis/operations.h"
#include "compiler/backend/interpreter/operation.h"
#include "tests/unit/rule_fixture.h"

namespace jrule::tests {

/// Indices of darts, arcs, handles and values, as they lie in memory. jmap text would number them anew.
inline std::string bits(Map const& map) {
  std::string text = fmt::format("limit {}\n", map.dart_limit());
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    text += fmt::format("{}{}:", map.contains(d) ? "" : "x", d);
    for (int const i : map.model().dimensions) {
      if (map.contains(d)) text += fmt::format(" {}", map.target(d, i));
    }
    for (std::size_t e = 0; e < map.embedding_count(); ++e) {
      if (map.contains(d)) text += fmt::format(" /{}", map.embedding(e).handle(d));
    }
    text += '\n';
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    for (Handle h = 0; h < map.embedding(e).value_count(); ++h) text += fmt::format("{} ", to_string(map.embedding(e).value(h)));
    text += '\n';
  }
  return text;
}

struct Operations {
  ir::Program program;
  std::vector<analysis::Verdict> verdicts{};
  rewrite::Workspace workspace{};

  explicit Operations(std::string const& text) : program(program_of(text)) {
    for (ir::RuleScheme const& rule : program.rules) {
      verdicts.push_back(analysis::analyze(rule));
      if (!verdicts.back().accepted()) throw std::runtime_error(rule.name + ": " + codes(verdicts.back()));
    }
    for (ir::Operation const& operation : program.operations) {
      if (auto const fault = ir::verify(operation, program)) throw std::runtime_error(*fault);
      if (!analysis::check_calls(operation, program, verdicts).empty()) throw std::runtime_error(operation.name + " is refused");
    }
  }
  std::size_t index(std::string const& name) const {
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
      if (program.operations[i].name == name) return i;
    }
    throw std::out_of_range(name);
  }
  Map empty() const { return Map(program.modelers.at(0)->model, program.modelers.at(0)->embeddings); }
  Result<std::optional<ir::Evaluated>> run(std::string const& name, Map& map, std::vector<ir::Evaluated> const& arguments = {},
                                           operation::Progress const& progress = {}) {
    return interpreter::run({program, verdicts}, index(name), map, arguments, workspace, progress);
  }
};

}  // namespace jrule::tests

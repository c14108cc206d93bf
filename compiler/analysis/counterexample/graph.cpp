#include "compiler/analysis/counterexample/graph.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "jrule/io.h"

namespace jrule::analysis {

namespace {

using Found = std::optional<Violation>;

Found outgoing_arcs(Graph const& graph, std::size_t column, int i) {
  for (Dart d = 0; d < graph.targets.size(); ++d) {
    bool const live = graph.contains(d);
    auto const& to = graph.targets[d][column];
    std::string text;
    if (!live) {
      if (to.empty()) continue;
      text = fmt::format("dart {} is deleted, but its {}-arc is not", d, i);
    } else if (auto const erased = std::find_if(to.begin(), to.end(), [&](Dart t) { return !graph.contains(t); });
               erased != to.end()) {
      text = fmt::format("dart {}: its {}-arc leads to dart {}, which is deleted", d, i, *erased);
    } else if (to.size() == 1) {
      continue;
    } else if (to.empty()) {
      text = fmt::format("dart {} has no {}-arc", d, i);
    } else if (to.size() > 2) {
      text = fmt::format("dart {} has {} {}-arcs, to darts {}", d, to.size(), i, fmt::join(to, ", "));
    } else if (to[0] == to[1]) {
      text = fmt::format("dart {} has two {}-arcs, both to dart {}", d, i, to[0]);
    } else {
      text = fmt::format("dart {} has two {}-arcs, to darts {} and {}", d, i, to[0], to[1]);
    }
    return Violation{Violation::Kind::incident_arcs, d, i, -1, std::move(text)};
  }
  return {};
}

// Each dart has one outgoing i-arc, so a dart that two lead to comes with one that none leads to.
Found incoming_arcs(Graph const& graph, std::size_t column, int i) {
  std::vector<Dart> incoming(graph.targets.size(), no_dart);
  for (Dart const d : graph.darts) {
    Dart const to = graph.targets[d][column][0];
    if (incoming[to] != no_dart) {
      return Violation{Violation::Kind::incident_arcs, to, i, -1,
                       fmt::format("dart {}: two {}-arcs lead to it, from darts {} and {}", to, i, incoming[to], d)};
    }
    incoming[to] = d;
  }
  return {};
}

}  // namespace

bool Graph::contains(Dart d) const { return std::binary_search(darts.begin(), darts.end(), d); }

Graph graph_of(Map const& map) {
  Graph graph;
  graph.targets.resize(map.dart_limit(), std::vector<std::vector<Dart>>(map.model().dimensions.size()));
  graph.darts = map.darts();
  for (Dart const d : graph.darts) {
    for (int const i : map.model().dimensions)
      graph.targets[d][static_cast<std::size_t>(map.model().column(i))] = {map.target(d, i)};
  }
  return graph;
}

std::optional<Violation> find_violation(Graph const& graph, Model const& model) {
  auto const column = [&](int i) { return static_cast<std::size_t>(model.column(i)); };
  for (int const i : model.dimensions) {
    if (Found v = outgoing_arcs(graph, column(i), i)) return v;
    if (Found v = incoming_arcs(graph, column(i), i)) return v;
  }
  // Now every column is a permutation.
  auto const next = [&](Dart d, int i) { return graph.targets[d][column(i)][0]; };
  for (int const i : model.dimensions) {
    if (model.is_oriented(i)) continue;
    for (Dart const d : graph.darts) {
      Dart const to = next(d, i), back = next(to, i);
      if (back == d) continue;
      return Violation{
          Violation::Kind::non_orientation, d, i, -1,
          fmt::format("dart {}: its {}-arc leads to dart {}, whose {}-arc leads to dart {}", d, i, to, i, back)};
    }
  }
  for (auto const& [i, j] : model.exchange) {
    for (Dart const d : graph.darts) {
      Dart const end = next(next(next(next(d, i), j), i), j);
      if (end == d) continue;
      return Violation{
          Violation::Kind::cycle, d, i, j,
          fmt::format("dart {}: the path {}{}{}{} does not return (it ends at dart {})", d, i, j, i, j, end)};
    }
  }
  if (!model.closed) return {};
  for (int const i : model.dimensions) {
    for (Dart const d : graph.darts) {
      if (next(d, i) != d) continue;
      return Violation{Violation::Kind::closed, d, i, -1,
                       fmt::format("dart {}: its {}-arc is a loop, but the model {} is closed", d, i, model.name)};
    }
  }
  return {};
}

std::string print_graph(Graph const& graph, Model const& model) {
  // The head is that of any map of the model; the number of darts and their lines follow.
  std::string const empty = print_jmap(Map(model));
  std::string text = empty.substr(0, empty.find("\ndarts "));
  text += fmt::format("\ndarts {}\n", graph.targets.size());
  for (Dart d = 0; d < graph.targets.size(); ++d) {
    std::vector<std::string> words;
    for (auto const& to : graph.targets[d]) words.push_back(to.empty() ? "-" : fmt::format("{}", fmt::join(to, "+")));
    text += fmt::format("{}{}\n", fmt::join(words, " "), graph.contains(d) ? "" : "  # deleted");
  }
  return text;
}

}  // namespace jrule::analysis

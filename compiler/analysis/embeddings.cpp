#include "compiler/analysis/embeddings.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/algebra/group.h"
#include "compiler/analysis/orbit_links.h"
#include "compiler/analysis/placement.h"
#include "compiler/analysis/representative.h"
#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

using Link = OrbitLink;
using Anchor = OrbitAnchor;

struct OrbitAnalysis {
  ir::RuleScheme const& rule;
  std::size_t embedding;
  algebra::Group const& group;
  Placement const& placement;
  PatternWords const& words;
  ir::Table const& left;
  ir::Table const& right;
  EmbeddingAnalysis& result;
  OrbitLinks joined = orbit_links(rule, false, right, rule.modeler->embeddings[embedding].orbit, group);
  std::vector<Link> const& links = joined.links;
  std::vector<Anchor> const& anchors = joined.anchors;

  EmbeddingSpec const& spec() const { return rule.modeler->embeddings[embedding]; }

  std::string orbit() const { return orbit_name(rule.model(), spec().orbit); }
  std::string orbits() const { return orbit_names(rule.model(), spec().orbit); }

  std::string node_list(OrbitComponent const& component) const {
    std::vector<ir::NodeId> ids;
    for (auto const& member : component.members) ids.push_back(member.node);
    std::sort(ids.begin(), ids.end());
    std::string text;
    for (ir::NodeId const id : ids) text += (text.empty() ? "`" : ", `") + rule.nodes[id].name + "`";
    return text;
  }

  void add_generator(OrbitComponent& component, Word const& word) const {
    Word const inverse = group.inverse(word);
    if (word.empty()) return;
    auto& known = component.generators;
    if (std::find(known.begin(), known.end(), word) == known.end() && std::find(known.begin(), known.end(), inverse) == known.end()) known.push_back(word);
  }

  // The component of `root`, its members reached along links; the links that close it give its generators.
  OrbitComponent grow(ir::NodeId root, std::vector<bool>& seen) const {
    OrbitComponent component;
    component.embedding = embedding;
    component.members.push_back({root, {}});
    std::vector<std::optional<Word>> path(rule.nodes.size());
    path[root] = Word{};
    seen[root] = true;
    for (std::size_t next = 0; next < component.members.size(); ++next) {
      ir::NodeId const at = component.members[next].node;
      for (Link const& link : links) {
        for (bool const forwards : {true, false}) {
          if ((forwards ? link.from : link.to) != at) continue;
          ir::NodeId const to = forwards ? link.to : link.from;
          if (path[to]) continue;
          path[to] = group.product(*path[at], forwards ? link.word : group.inverse(link.word));
          seen[to] = true;
          component.members.push_back({to, *path[to]});
        }
      }
    }
    for (Link const& link : links) {
      if (!path[link.from]) continue;
      add_generator(component, group.product(group.product(*path[link.from], link.word), group.inverse(*path[link.to])));
    }
    return component;
  }

  Word const& path_of(OrbitComponent const& component, ir::NodeId id) const {
    return std::find_if(component.members.begin(), component.members.end(), [&](auto const& m) { return m.node == id; })->path;
  }

  // The anchor's dart from the root's pattern dart u: the hook h and the e with dart = m(u, h)·e.
  struct Place {
    std::size_t hook;
    std::optional<Word> element;
    Anchor const* anchor;
  };
  Place place(OrbitComponent const& component, Anchor const& anchor) const {
    std::size_t const h = placement.hook(anchor.preserved);
    auto const translated = placement.translate(h, group.product(path_of(component, anchor.node), anchor.word));
    auto const& offset = placement.offset(anchor.preserved);
    if (!translated || !offset) return {h, {}, &anchor};
    return {h, group.product(group.product(*translated, *offset), anchor.tail), &anchor};
  }

  std::vector<Anchor const*> anchors_of(OrbitComponent const& component) const {
    std::vector<Anchor const*> found;
    for (Anchor const& anchor : anchors) {
      for (auto const& member : component.members) {
        if (member.node == anchor.node) found.push_back(&anchor);
      }
    }
    return found;
  }

  // A dart that exists before: m(u·word, node)·tail, u being the root's pattern dart.
  struct Matched {
    Word word;
    ir::NodeId node;
    Word tail;
    bool operator==(Matched const&) const = default;
  };
  Matched matched(OrbitComponent const& component, Anchor const& anchor) const {
    return {group.product(path_of(component, anchor.node), anchor.word), anchor.preserved, anchor.tail};
  }

  // Along the arcs that the left side matches, as far as there are.
  Matched step(Matched at, Word const& path) const {
    for (Letter const letter : path) {
      ir::Arc const* const arc = letter.conjugate ? left.in(at.node, letter.dimension) : left.out(at.node, letter.dimension);
      if (at.tail.empty() && arc) {
        at = {group.product(at.word, letter.conjugate ? group.inverse(arc->word) : arc->word), letter.conjugate ? arc->source : arc->target, {}};
      } else {
        at.tail = group.product(at.tail, {letter});
      }
    }
    return at;
  }

  // Does a path within π lead from one dart to the other? Matched arcs may say so where the places of their nodes do not: at a node
  // far from its hook, or through a cycle of the left side. A search of the paths that are no longer than a rule's.
  bool joined_before(Matched const& from, Matched const& to) const {
    constexpr std::size_t limit = 64;
    std::vector<Matched> reached{from};
    for (std::size_t next = 0; next < reached.size(); ++next) {
      if (reached[next].node == to.node && reached[next].tail == to.tail && words.equal(reached[next].word, to.word)) return true;
      for (Word const& word : spec().orbit.words) {
        for (Word const& path : {word, group.inverse(word)}) {
          Matched const end = step(reached[next], path);
          if (reached.size() < limit && std::find(reached.begin(), reached.end(), end) == reached.end()) reached.push_back(end);
        }
      }
    }
    return false;
  }

  struct Merge {
    ir::NodeId first, second;
    std::string text;
  };
  // Are the darts that exist before of one π-orbit before too? If not, where it shows.
  std::optional<Merge> find_merge(OrbitComponent const& component, std::vector<Anchor const*> const& found) const {
    Place const base = place(component, *found.front());
    for (Anchor const* const anchor : found) {
      if (anchor == found.front()) continue;
      Place const other = place(component, *anchor);
      bool const together = other.hook == base.hook && other.element && base.element &&
                            group.in_orbit(group.product(group.inverse(*base.element), *other.element), spec().orbit);
      if (!together && !joined_before(matched(component, *base.anchor), matched(component, *anchor))) {
        return Merge{base.anchor->preserved, anchor->preserved,
                     base.anchor->preserved == anchor->preserved
                         ? fmt::format("darts of `{}` that may be of different {} before are of one afterwards", rule.nodes[anchor->preserved].name, orbits())
                         : fmt::format("`{}` and `{}` may be of different {} before and are of one afterwards",
                                       rule.nodes[base.anchor->preserved].name, rule.nodes[anchor->preserved].name, orbits())};
      }
    }
    for (Word const& generator : component.generators) {
      auto const translated = placement.translate(base.hook, generator);
      bool const together =
          translated && base.element &&
          group.in_orbit(group.product(group.product(group.inverse(*base.element), *translated), *base.element), spec().orbit);
      Matched const first = matched(component, *base.anchor);
      if (!together && !joined_before(first, {group.product(generator, first.word), first.node, first.tail})) {
        return Merge{base.anchor->preserved, base.anchor->preserved,
                     fmt::format("a dart of `{}` and the one that {} leads to in the pattern may be of different {} before and are of one afterwards",
                                 rule.nodes[base.anchor->preserved].name, describe(generator), orbits())};
      }
    }
    return {};
  }

  void refuse(Code code, source::Span span, ir::NodeId id, std::string message, std::vector<source::Label> labels, std::vector<std::string> notes) {
    result.refusals.push_back({{.code = code, .span = span, .message = std::move(message), .labels = std::move(labels), .notes = std::move(notes)}, id, -1, -1});
  }

  source::Span right_span(ir::NodeId id) const { return *rule.nodes[id].right_span; }

  void refuse_missing(OrbitComponent const& component) {
    std::vector<source::Label> labels;
    for (auto const& member : component.members) labels.push_back({right_span(member.node), "part of this new " + orbit()});
    std::sort(labels.begin(), labels.end(), [](auto const& a, auto const& b) { return a.span < b.span; });
    refuse(Code::missing_value, labels.front().span, component.members.front().node,
           fmt::format("the new {} of {} gets no `{}`", orbit(), node_list(component), spec().name), labels,
           {fmt::format("give it on one of these nodes: `{} {{ {} = …; }}`, or declare a `default` for `{}`", rule.nodes[component.members.front().node].name,
                        spec().name, spec().name)});
  }

  // The component is rooted at the clause's node: its value is computed at one of the pattern darts u, u·g, …
  void warn_if_dependent(OrbitComponent const& component, ir::Clause const& clause) {
    for (Word const& g : component.generators) {
      if (words.trivial(g)) continue;
      ir::Expr const* const part = RepresentativeCheck(rule, group, placement, words).changed_by(*clause.value, g);
      if (!part) continue;
      std::string const name = rule.nodes[clause.node].name;
      result.warnings.push_back(
          {.code = Code::representative_dependence, .span = part->span,
           .message = fmt::format("the `{}` of the {} of `{}` depends on the dart that it is computed at", spec().name, orbit(), name),
           .labels = {{rule.nodes[clause.node].right_span.value(), fmt::format("{} leads from one dart of the pattern to another whose `{}` is of the same {}",
                                                                              describe(g), name, orbit())}},
           .notes = {"this may be another value there, and which of the darts is taken is not said",
                     "let each dart give the same: `mean` or another aggregate over an orbit, or an expression that is symmetric in both"}});
      return;
    }
  }

  void classify(OrbitComponent component, std::vector<std::size_t> const& clauses) {
    if (clauses.size() > 1) {
      ir::Clause const& first = rule.clauses[clauses[0]];
      ir::Clause const& second = rule.clauses[clauses[1]];
      refuse(Code::two_clauses, second.span, second.node, fmt::format("`{}` and `{}` are of one {}, which gets two values of `{}`", rule.nodes[first.node].name, rule.nodes[second.node].name, orbit(), spec().name),
             {{first.span, "the first value"}}, {"an orbit has one value of each embedding; give it on one of its nodes"});
      return;
    }
    if (!clauses.empty()) {
      component.clause = clauses.front();
      warn_if_dependent(component, rule.clauses[clauses.front()]);
    }
    auto const found = anchors_of(component);
    if (found.empty()) {
      component.kind = OrbitComponent::Kind::fresh;
      if (!component.clause && !rule.modeler->has_default(embedding)) return refuse_missing(component);
      result.orbits.push_back(std::move(component));
      return;
    }
    if (component.clause) {
      component.kind = OrbitComponent::Kind::assign;
      result.orbits.push_back(std::move(component));
      return;
    }
    if (auto const merge = find_merge(component, found)) {
      component.kind = OrbitComponent::Kind::merge;
      if (spec().merge == MergePolicy::none) {
        refuse(Code::missing_merge, right_span(merge->second), merge->second,
               fmt::format("the rule merges {} of {} without saying which `{}` they get", orbits(), node_list(component), spec().name),
               {{right_span(merge->first), merge->text}},
               {fmt::format("give the value on one of these nodes: `{} {{ {} = …; }}`, or declare a `merge` policy for `{}`", rule.nodes[merge->first].name,
                            spec().name, spec().name)});
        return;
      }
      result.orbits.push_back(std::move(component));
      return;
    }
    component.kind = OrbitComponent::Kind::inherit;
    for (auto const& member : component.members) {
      if (rule.nodes[member.node].added()) component.sources.push_back(source_for(component, member, *found.front()));
    }
    if (!component.sources.empty()) result.orbits.push_back(std::move(component));
  }

  OrbitComponent::Source source_for(OrbitComponent const& component, OrbitComponent::Member const& member, Anchor const& anchor) const {
    // (u, added) ~ (u·ā·b, anchored), a and b being the paths from the root.
    Word const to_anchored = group.product(group.inverse(member.path), path_of(component, anchor.node));
    return {member.node, group.product(to_anchored, anchor.word), anchor.preserved, anchor.tail};
  }

  void run() {
    // A component is rooted at its clause's node, so that the clause's expression is evaluated there.
    std::vector<ir::NodeId> order;
    for (ir::Clause const& clause : rule.clauses) {
      if (clause.embedding == embedding) order.push_back(clause.node);
    }
    for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
      if (!rule.nodes[id].deleted()) order.push_back(id);
    }
    std::vector<bool> seen(rule.nodes.size(), false);
    for (ir::NodeId const root : order) {
      if (seen[root]) continue;
      OrbitComponent component = grow(root, seen);
      std::vector<std::size_t> clauses;
      for (std::size_t c = 0; c < rule.clauses.size(); ++c) {
        bool const member = std::any_of(component.members.begin(), component.members.end(), [&](auto const& m) { return m.node == rule.clauses[c].node; });
        if (rule.clauses[c].embedding == embedding && member) clauses.push_back(c);
      }
      classify(std::move(component), clauses);
    }
  }
};

}  // namespace

EmbeddingAnalysis analyze_embeddings(ir::RuleScheme const& completed, PatternWords const& words) {
  EmbeddingAnalysis result;
  algebra::Group const group(completed.model());
  Placement const placement(completed, group);
  ir::Table const left(completed.nodes.size(), completed.left), right(completed.nodes.size(), completed.right);
  for (std::size_t e = 0; e < completed.modeler->embeddings.size(); ++e) {
    OrbitAnalysis{completed, e, group, placement, words, left, right, result}.run();
  }
  return result;
}

}  // namespace jrule::analysis

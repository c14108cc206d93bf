#include "compiler/analysis/certify.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "compiler/algebra/group.h"
#include "compiler/analysis/alternating_paths.h"
#include "compiler/analysis/pattern.h"

namespace jrule::analysis {

namespace {

class Certifier {
 public:
  explicit Certifier(ir::RuleScheme const& rule) : rule_(rule) {}

  Certificate run() {
    imply();
    check_incident_arcs();
    check_non_orientation();
    for (auto const& [i, j] : rule_.model().exchange) check_cycles(i, j);
    if (rule_.model().closed) check_loops();
    return std::move(certificate_);
  }

 private:
  [[noreturn]] void unproved(std::string const& what) const { throw std::logic_error("rule " + rule_.name + ": no proof of " + what); }

  // ---- Words ----

  Word joined(std::vector<Word> const& words) const {
    Word all;
    for (Word const& word : words) all.insert(all.end(), word.begin(), word.end());
    return all;
  }
  Word conjugate(Word const& word) const { return algebra::conjugate(rule_.model(), word); }
  static Letter forwards(int dimension) { return {static_cast<std::uint8_t>(dimension), false}; }
  Letter backwards(int dimension) const { return {static_cast<std::uint8_t>(dimension), rule_.model().is_oriented(dimension)}; }

  Vanishing trace(Word word) const {
    auto steps = algebra::cancel(rule_.model(), word);
    if (!steps) unproved(to_string(word) + " = ε in Γ");
    return {std::move(word), *std::move(steps)};
  }

  Proof prove(Word word) {
    auto const derivation = words_.derive(word);
    if (!derivation) unproved(to_string(word) + " = ε on the pattern");
    return prove(*derivation, {});
  }

  /// That what is derived acts as ε, with `after` behind it.
  Proof prove(Derivation const& derivation, Word const& after) {
    Word word = joined({derivation.word, after});
    Proof proof{word, {}, {}};
    for (Derivation::Step const& step : derivation.steps) {
      std::size_t const relation = relate(step.relation);
      Word const& r = words_.relations()[step.relation].word;
      Word const product = joined({step.prefix, step.conjugate ? conjugate(r) : r, conjugate(step.prefix), word});
      Word const result = joined({step.result, after});
      proof.steps.push_back({step.prefix, walk(step.prefix), relation, step.conjugate, result, trace(joined({product, conjugate(result)}))});
      word = result;
    }
    proof.trace = trace(word);
    return proof;
  }

  Word word_of(Generator const& generator) const {
    switch (generator.kind) {
      case Generator::Kind::left_word: return rule_.left.arcs[generator.index].word;
      case Generator::Kind::right_word: return rule_.right.arcs[generator.index].word;
      case Generator::Kind::hook_type: break;
    }
    return {rule_.hook_type[generator.index]};
  }

  Walk walk(Word const& word) {
    auto const steps = words_.walk_in_pattern(word);
    if (!steps) unproved(to_string(word) + " stays in the pattern");
    Word walked;
    for (PatternStep const& step : *steps) {
      if (step.letter) close(step.letter->dimension);
      Word const along = step.letter ? Word{*step.letter} : word_of(step.generator);
      walked = joined({walked, step.backwards ? conjugate(along) : along});
    }
    return {*steps, trace(joined({walked, conjugate(word)}))};
  }

  // ---- What the left side says, listed when it is first needed ----

  void place(ir::NodeId node) {
    auto const& evidence = placement_.evidence(node);
    if (!evidence || !placed_.insert(node).second) return;
    ir::Arc const& arc = rule_.left.arcs[evidence->arc];
    place(evidence->forwards ? arc.source : arc.target);
    Word const given = evidence->forwards ? joined({conjugate(arc.word), *placement_.offset(arc.source), {forwards(arc.dimension)}})
                                          : joined({arc.word, *placement_.offset(arc.target), {backwards(arc.dimension)}});
    Word const& offset = *placement_.offset(node);
    certificate_.placements.push_back({*evidence, offset, trace(joined({given, conjugate(offset)}))});
  }

  /// x_s·d·x̄_t·w̄, which the arc makes ε.
  Word around(ir::Arc const& arc) {
    place(arc.source);
    place(arc.target);
    return joined({*placement_.offset(arc.source), {forwards(arc.dimension)}, conjugate(*placement_.offset(arc.target)), conjugate(arc.word)});
  }

  /// The position in the certificate of one of the relations.
  std::size_t relate(std::size_t r) {
    if (auto const known = related_.find(r); known != related_.end()) return known->second;
    Relation const& relation = words_.relations()[r];
    Word given;
    if (relation.evidence.kind == RelationEvidence::Kind::arc) {
      given = around(rule_.left.arcs[relation.evidence.arcs.front()]);
    } else if (relation.evidence.kind == RelationEvidence::Kind::single_dart) {
      given = word_of(relation.evidence.generator);
    } else {
      for (ArcIndex const arc : relation.evidence.arcs) given = joined({given, rule_.left.arcs[arc].word});
    }
    std::size_t const position = certificate_.relations.size();
    certificate_.relations.push_back({relation.evidence, relation.word, trace(joined({given, conjugate(relation.word)}))});
    related_[r] = position;
    return position;
  }

  void close(int dimension) {
    if (!closed_.insert(dimension).second) return;
    auto const& all = words_.closure();
    auto const found = std::find_if(all.begin(), all.end(), [&](ClosureEvidence const& c) { return c.dimension == dimension; });
    if (found == all.end()) unproved("a closed pattern");
    ClosureEvidence evidence = *found;
    Word const word = evidence.relation ? words_.relations()[*evidence.relation].word : word_of(evidence.generator);
    for (Letter const letter : word) close(letter.dimension);
    if (evidence.relation) evidence.relation = relate(*evidence.relation);
    certificate_.closure.push_back(evidence);
  }

  void imply() {
    auto const& arcs = completed_.rule.left.arcs;
    for (std::size_t k = 0; k < completed_.implied.size(); ++k) {
      ir::Arc const& arc = arcs[rule_.left.arcs.size() + k];
      ImpliedEvidence const& evidence = completed_.implied[k];
      Word given;
      Walk along;
      if (evidence.kind == ImpliedEvidence::Kind::placement) {
        along = walk(arc.word);
        given = around(arc);
      } else {
        for (ArcIndex const other : evidence.arcs) given = joined({given, arcs[other].word});
        given = joined({given, arc.word});
      }
      certificate_.implied.push_back({arc, evidence, trace(given), std::move(along)});
    }
  }

  // ---- The conditions ----

  void check_incident_arcs() {
    auto const index = [](SideView const& view, ir::Arc const* arc) { return arc ? std::optional(view.index_of(*arc)) : std::nullopt; };
    for (ir::NodeId node = 0; node < rule_.nodes.size(); ++node) {
      for (int const d : rule_.model().dimensions) {
        certificate_.incident_arcs.push_back({node, d,
                                              {index(left_, left_.table.out(node, d)), index(right_, right_.table.out(node, d))},
                                              {index(left_, left_.table.in(node, d)), index(right_, right_.table.in(node, d))}});
      }
    }
  }

  void check_non_orientation() {
    for (SideView const* view : {&left_, &right_}) {
      for (ir::Arc const& arc : view->side.arcs) {
        if (rule_.model().is_oriented(arc.dimension) || !view->changed(arc)) continue;
        ir::Arc const* const reverse = view->table.out(arc.target, arc.dimension);
        if (!reverse || reverse->target != arc.source) unproved("a reverse");
        if (reverse < &arc) continue;  // listed with that one
        certificate_.reverses.push_back({view == &right_, view->index_of(arc), view->index_of(*reverse), prove(joined({reverse->word, arc.word}))});
      }
    }
  }

  Word word_of(AlternatingPath const& path) const {
    Word word;
    for (ir::Arc const* arc : path) word = joined({word, arc->word});
    return word;
  }

  void check_cycles(int i, int j) {
    std::set<ir::Arc const*> listed;  // arcs of this pair's cycles; of non-oriented ones, their reverses too
    for (CycleObligation const& obligation : cycle_obligations(left_, right_, rule_.model(), i, j)) {
      SideView const& view = obligation.added ? right_ : left_;
      if (obligation.four_steps()) {
        if (listed.contains(obligation.path.front())) continue;
        Certificate::Cycle cycle{obligation.added, {}, {}};
        for (std::size_t k = 0; k < 4; ++k) cycle.arcs[k] = view.index_of(*obligation.path[k]);
        for (ir::Arc const* arc : view.arcs_of(obligation.path, rule_.model())) listed.insert(arc);
        if (obligation.added) cycle.proof = prove(word_of(obligation.path));
        certificate_.cycles.push_back(std::move(cycle));
      } else if (!obligation.added) {  // the added path is its partner
        Certificate::Paths paths{{i, j}, {}, {}, {}};
        for (ir::Arc const* arc : obligation.path) paths.left.push_back(left_.index_of(*arc));
        for (ir::Arc const* arc : obligation.partner) paths.right.push_back(right_.index_of(*arc));
        paths.proof = prove(joined({word_of(obligation.path), conjugate(word_of(obligation.partner))}));
        certificate_.paths.push_back(std::move(paths));
      }
    }
  }

  void check_loops() {
    for (ir::Arc const& arc : right_.side.arcs) {
      if (arc.source != arc.target || !right_.changed(arc)) continue;
      auto const derivation = words_.derive_conjugate_of_letter(arc.word);
      if (!derivation) unproved("an arc that is no loop");
      auto const conjugation = *algebra::conjugate_of_letter(group_, derivation->steps.empty() ? arc.word : derivation->steps.back().result);
      Word const same = joined({conjugation.by, {conjugation.letter}, conjugate(conjugation.by)});
      certificate_.no_loops.push_back({right_.index_of(arc), conjugation, prove(*derivation, conjugate(same))});
    }
  }

  ir::RuleScheme const& rule_;
  Pattern const pattern_{rule_};
  algebra::Group const& group_ = pattern_.group;
  Placement const& placement_ = pattern_.placement;
  PatternWords const& words_ = pattern_.words;
  Completed const& completed_ = pattern_.completed;
  SideView left_{rule_.nodes.size(), completed_.rule.left, completed_.rule.right};
  SideView right_{rule_.nodes.size(), completed_.rule.right, completed_.rule.left};
  std::set<ir::NodeId> placed_{};
  std::map<std::size_t, std::size_t> related_{};
  std::set<int> closed_{};
  Certificate certificate_{};
};

}  // namespace

Certificate certify(ir::RuleScheme const& rule) { return Certifier(rule).run(); }

}  // namespace jrule::analysis

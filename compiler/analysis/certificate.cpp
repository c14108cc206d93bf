#include "compiler/analysis/certificate.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/source/place.h"

namespace jrule::analysis {

namespace {

class Printer {
 public:
  Printer(Certificate const& certificate, ir::RuleScheme const& rule, source::Sources const& sources)
      : certificate_(certificate), rule_(rule), sources_(sources) {}

  std::string run() {
    line("certificate of the rule {} on {}, for a {}{}", rule_.name, rule_.modeler->name, ir::map_name(rule_.model()), place(rule_.span));
    line("# L1, R1, I1: an arc of the left side, of the right side, one that the left side implies and that is on both sides");
    line("# (p,q) between two words: letter q moves to letter p, past exchangeable ones, and both cancel; an oriented letter turns");
    line("# round, 1 to ~1, where it passes or is passed. That two words are equal is shown by the first times the conjugate of the second");
    print_rule();
    print_left_side();
    print_incident_arcs();
    print_reverses();
    print_cycles();
    print_no_loops();
    return std::move(text_);
  }

 private:
  template <typename... T>
  void line(fmt::format_string<T...> format, T&&... arguments) {
    text_ += fmt::format(format, std::forward<T>(arguments)...) + '\n';
  }

  // ---- Names ----

  std::string const& node(ir::NodeId id) const { return rule_.nodes[id].name; }
  std::string place(source::Span span) const {
    auto const range = source::range_of(sources_, span);
    return range ? fmt::format("  {}:{}", source::file_of(sources_, span)->path, range->begin.line) : "";
  }
  std::string arc_name(bool left, ArcIndex arc) const {
    std::size_t const written = (left ? rule_.left : rule_.right).arcs.size();
    return arc < written ? fmt::format("{}{}", left ? 'L' : 'R', arc + 1) : fmt::format("I{}", arc - written + 1);
  }
  template <typename Arcs>
  std::string arc_names(bool left, Arcs const& arcs) const {
    std::string names;
    for (ArcIndex const arc : arcs) names += (names.empty() ? "" : " ") + arc_name(left, arc);
    return names;
  }
  ir::Arc const& arc_at(bool left, ArcIndex arc) const {
    auto const& arcs = (left ? rule_.left : rule_.right).arcs;
    return arc < arcs.size() ? arcs[arc] : certificate_.implied[arc - arcs.size()].arc;
  }
  std::string describe(ir::Arc const& arc) const {
    std::string word = arc.word.empty() ? "" : to_string(arc.word);
    if (arc.word.size() == 1) word = '[' + word + ']';
    return fmt::format("{} -{}{}-> {}", node(arc.source), arc.dimension, word, node(arc.target));
  }

  // ---- Words that are ε ----

  std::string chain(Vanishing const& trace) const {
    Word word = trace.word;
    std::string text = to_string(word);
    for (algebra::Cancellation const step : trace.steps) {
      word = algebra::after(rule_.model(), std::move(word), step);
      text += fmt::format(" ({},{}) {}", step.left + 1, step.right + 1, to_string(word));
    }
    return text;
  }

  std::string generator_name(Generator const& generator) const {
    using Kind = Generator::Kind;
    if (generator.kind == Kind::hook_type) return fmt::format("{} of the hook's type", to_string(Word{rule_.hook_type[generator.index]}));
    return fmt::format("the word of {}", arc_name(generator.kind == Kind::left_word, generator.index));
  }

  // Nothing where the letters of the word itself are walked.
  std::string describe(Walk const& walk) const {
    bool const letters = std::all_of(walk.steps.begin(), walk.steps.end(), [](PatternStep const& step) { return step.letter.has_value(); });
    if (letters) return "";
    std::string text;
    for (PatternStep const& step : walk.steps) {
      text += text.empty() ? " along " : ", ";
      text += step.letter ? to_string(Word{*step.letter}) : (step.backwards ? "the conjugate of " : "") + generator_name(step.generator);
    }
    return fmt::format("{}: {}", text, chain(walk.trace));
  }

  void print_proof(std::string const& what, Proof const& proof) {
    line("  {}: {}", what, proof.steps.empty() ? chain(proof.trace) : fmt::format("{} is ε on the pattern", to_string(proof.word)));
    Word word = proof.word;
    for (Proof::Step const& step : proof.steps) {
      std::string const prefix = step.prefix.empty() ? "" : fmt::format(" after {}{}", to_string(step.prefix), describe(step.walk));
      line("    {} is {}, by {}F{}{}: {}", to_string(word), to_string(step.result), step.conjugate ? "the conjugate of " : "", step.relation + 1, prefix,
           chain(step.trace));
      word = step.result;
    }
    if (!proof.steps.empty() && !word.empty()) line("    {}", chain(proof.trace));
  }

  // ---- Sections ----

  void print_rule() {
    for (bool const left : {true, false}) {
      auto const& arcs = (left ? rule_.left : rule_.right).arcs;
      if (!arcs.empty()) line("{} side", left ? "left" : "right");
      for (ArcIndex k = 0; k < arcs.size(); ++k) line("  {}  {}{}", arc_name(left, k), describe(arcs[k]), place(arcs[k].span));
    }
  }

  void print_left_side() {
    if (!certificate_.placements.empty()) line("where the darts of left nodes lie from those of {}", node(rule_.hooks.front()));
    for (auto const& p : certificate_.placements) {
      line("  {} at {}, from {}: {}", node(p.evidence.node), to_string(p.offset), arc_name(true, p.evidence.arc), chain(p.trace));
    }
    if (!certificate_.relations.empty()) line("words that the left side makes ε on the pattern");
    for (std::size_t k = 0; k < certificate_.relations.size(); ++k) {
      auto const& r = certificate_.relations[k];
      static constexpr std::string_view why[] = {"the arc", "the arc and its reverse", "the cycle"};
      std::string const from = r.evidence.kind == RelationEvidence::Kind::single_dart
                                   ? fmt::format("{}, since the hook {} determines a single dart", generator_name(r.evidence.generator), node(rule_.hooks[r.evidence.hook]))
                                   : fmt::format("{} {}", why[static_cast<std::size_t>(r.evidence.kind)], arc_names(true, r.evidence.arcs));
      line("  F{}  {}, from {}: {}", k + 1, to_string(r.word), from, chain(r.trace));
    }
    if (!certificate_.closure.empty()) line("dimensions that lead from the pattern into the pattern");
    for (auto const& c : certificate_.closure) {
      bool const hook_type = !c.relation && c.generator.kind == Generator::Kind::hook_type;
      line("  {}: {}", c.dimension, hook_type ? "of the hook's type" : c.relation ? fmt::format("F{}", *c.relation + 1) : generator_name(c.generator));
    }
    if (!certificate_.implied.empty()) line("arcs that the left side implies");
    for (std::size_t k = 0; k < certificate_.implied.size(); ++k) {
      auto const& implied = certificate_.implied[k];
      using Kind = ImpliedEvidence::Kind;
      std::string const why = implied.evidence.kind == Kind::reverse ? "the reverse of " + arc_names(true, implied.evidence.arcs)
                              : implied.evidence.kind == Kind::cycle ? "closes the cycle of " + arc_names(true, implied.evidence.arcs)
                                                                     : "there in every map" + describe(implied.walk);
      line("  I{}  {}, {}: {}", k + 1, describe(implied.arc), why, chain(implied.trace));
    }
  }

  void print_incident_arcs() {
    line("incident arcs (paper, Def. 22)");
    for (auto const& entry : certificate_.incident_arcs) {
      auto const arcs = [&](Certificate::IncidentArcs::Direction const& direction) {
        auto const& [left, right] = direction;
        if (!left && !right) return std::string("not matched");
        if (!left || !right) return arc_name(left.has_value(), left ? *left : *right);
        return fmt::format("{} before and {} after", arc_name(true, *left), arc_name(false, *right));
      };
      ir::Node const& at = rule_.nodes[entry.node];
      line("  {} node {}, dimension {}: out {}; in {}", at.added() ? "added" : at.deleted() ? "deleted" : "preserved", at.name, entry.dimension, arcs(entry.out),
           arcs(entry.in));
    }
  }

  void print_reverses() {
    if (!certificate_.reverses.empty()) line("reverses of added and deleted arcs (paper, Def. 24)");
    for (auto const& entry : certificate_.reverses) {
      std::string const arc = arc_name(!entry.added, entry.arc);
      print_proof(entry.arc == entry.reverse ? fmt::format("{} reverses itself", arc) : fmt::format("{} reverses {}", arc_name(!entry.added, entry.reverse), arc),
                  entry.proof);
    }
  }

  void print_cycles() {
    if (!certificate_.cycles.empty() || !certificate_.paths.empty()) line("cycles through added and deleted arcs (paper, Def. 27)");
    for (auto const& cycle : certificate_.cycles) {
      std::string dimensions;
      for (ArcIndex const arc : cycle.arcs) dimensions += std::to_string(arc_at(!cycle.added, arc).dimension);
      std::string const what = fmt::format("{} {} from {}: {}", cycle.added ? "added cycle" : "left cycle", dimensions,
                                           node(arc_at(!cycle.added, cycle.arcs[0]).source), arc_names(!cycle.added, cycle.arcs));
      if (cycle.proof) print_proof(what, *cycle.proof);
      if (!cycle.proof) line("  {}", what);
    }
    for (auto const& paths : certificate_.paths) {
      std::string dimensions;
      for (ArcIndex const arc : paths.left) dimensions += std::to_string(arc_at(true, arc).dimension);
      print_proof(fmt::format("path {} from {} to {}: {} replaced by {}", dimensions, node(arc_at(true, paths.left.front()).source),
                              node(arc_at(true, paths.left.back()).target), arc_names(true, paths.left), arc_names(false, paths.right)),
                  paths.proof);
    }
  }

  void print_no_loops() {
    if (!certificate_.no_loops.empty()) line("added arcs that are no loops, since single letters move every dart");
    for (auto const& entry : certificate_.no_loops) {
      auto const& [by, letter] = entry.conjugation;
      print_proof(fmt::format("{} carries {} between {} and its conjugate", arc_name(false, entry.arc), to_string(Word{letter}), to_string(by)), entry.proof);
    }
  }

  Certificate const& certificate_;
  ir::RuleScheme const& rule_;
  source::Sources const& sources_;
  std::string text_;
};

}  // namespace

std::string print(Certificate const& certificate, ir::RuleScheme const& rule, source::Sources const& sources) {
  return Printer(certificate, rule, sources).run();
}

}  // namespace jrule::analysis

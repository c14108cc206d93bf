#include "tests/certificate/mutants.h"

#include <functional>
#include <utility>

namespace jrule::certificate {

namespace {

using analysis::ArcIndex;
using analysis::Certificate;
using analysis::Proof;
using analysis::Vanishing;

/// Where something stands in a certificate, and in its copies.
template <typename T>
using Place = std::function<T&(Certificate&)>;

class Mutants {
 public:
  Mutants(Certificate const& right, Model const& model)
      : right_(right), extra_{static_cast<std::uint8_t>(model.dimensions.front()), false} {}

  std::vector<Mutant> run() {
    mutate_left_side();
    mutate_conditions();
    return std::move(all_);
  }

 private:
  template <typename Edit>
  void add(std::string what, Edit const& edit) {
    Mutant mutant{std::move(what), right_};
    edit(mutant.certificate);
    all_.push_back(std::move(mutant));
  }

  /// Leaves out each entry of a list, and mutates it.
  template <typename T>
  void each(std::vector<T> Certificate::* list, std::string const& kind, std::function<void(std::string const&, Place<T> const&)> const& mutate) {
    for (std::size_t k = 0; k < (right_.*list).size(); ++k) {
      std::string const name = kind + " " + std::to_string(k + 1);
      add(name + ": left out", [&](Certificate& c) { (c.*list).erase((c.*list).begin() + static_cast<std::ptrdiff_t>(k)); });
      mutate(name, [list, k](Certificate& c) -> T& { return (c.*list)[k]; });
    }
  }

  void word(std::string const& name, Place<Word> const& at) {
    add(name + ": another word", [&](Certificate& c) { at(c).push_back(extra_); });
  }
  void index(std::string const& name, Place<std::size_t> const& at) {
    add(name + ": the next one", [&](Certificate& c) { ++at(c); });
    add(name + ": one that is not there", [&](Certificate& c) { at(c) += 1000; });
  }
  void trace(std::string const& name, Place<Vanishing> const& at) {
    word(name + ", the trace's", [at](Certificate& c) -> Word& { return at(c).word; });
    Certificate right = right_;
    if (at(right).steps.empty()) return;
    add(name + ": a step less", [&](Certificate& c) { at(c).steps.pop_back(); });
    add(name + ": a step too many", [&](Certificate& c) { at(c).steps.push_back(at(c).steps.back()); });
    add(name + ": a step backwards", [&](Certificate& c) { std::swap(at(c).steps.front().left, at(c).steps.front().right); });
  }
  void walk(std::string const& name, Place<analysis::Walk> const& at) {
    trace(name + ", the walk", [at](Certificate& c) -> Vanishing& { return at(c).trace; });
    Certificate right = right_;
    for (std::size_t k = 0; k < at(right).steps.size(); ++k) {
      add(name + ": a step of the walk left out", [&](Certificate& c) { at(c).steps.erase(at(c).steps.begin() + static_cast<std::ptrdiff_t>(k)); });
      add(name + ": a step elsewhere", [&](Certificate& c) {
        auto& step = at(c).steps[k];
        if (step.letter) step.letter->dimension = max_dimension + 1;
        else step.generator.index += 1000;
      });
    }
  }
  void proof(std::string const& name, Place<Proof> const& at) {
    word(name, [at](Certificate& c) -> Word& { return at(c).word; });
    trace(name, [at](Certificate& c) -> Vanishing& { return at(c).trace; });
    Certificate right = right_;
    for (std::size_t k = 0; k < at(right).steps.size(); ++k) {
      auto const step = [at, k](Certificate& c) -> Proof::Step& { return at(c).steps[k]; };
      std::string const step_name = name + ", step " + std::to_string(k + 1);
      add(step_name + ": left out", [&](Certificate& c) { at(c).steps.erase(at(c).steps.begin() + static_cast<std::ptrdiff_t>(k)); });
      word(step_name, [step](Certificate& c) -> Word& { return step(c).prefix; });
      word(step_name, [step](Certificate& c) -> Word& { return step(c).result; });
      index(step_name, [step](Certificate& c) -> std::size_t& { return step(c).relation; });
      trace(step_name, [step](Certificate& c) -> Vanishing& { return step(c).trace; });
      walk(step_name, [step](Certificate& c) -> analysis::Walk& { return step(c).walk; });
    }
  }

  void mutate_left_side() {
    each<Certificate::Placement>(&Certificate::placements, "placement", [&](std::string const& name, auto const& at) {
      word(name, [at](Certificate& c) -> Word& { return at(c).offset; });
      trace(name, [at](Certificate& c) -> Vanishing& { return at(c).trace; });
      index(name, [at](Certificate& c) -> ArcIndex& { return at(c).evidence.arc; });
    });
    each<Certificate::Relation>(&Certificate::relations, "relation", [&](std::string const& name, auto const& at) {
      word(name, [at](Certificate& c) -> Word& { return at(c).word; });
      trace(name, [at](Certificate& c) -> Vanishing& { return at(c).trace; });
      Certificate right = right_;
      if (at(right).evidence.arcs.empty()) {
        add(name + ": another hook", [&](Certificate& c) { at(c).evidence.hook += 1000; });
        add(name + ": another word of the rule", [&](Certificate& c) { at(c).evidence.generator.index += 1000; });
        return;
      }
      // (The next arc may be the reverse, which says the same.)
      add(name + ": an arc that is not there", [&](Certificate& c) { at(c).evidence.arcs.front() += 1000; });
      add(name + ": an arc less", [&](Certificate& c) { at(c).evidence.arcs.pop_back(); });
    });
    each<analysis::ClosureEvidence>(&Certificate::closure, "closure", [&](std::string const& name, auto const& at) {
      add(name + ": another dimension", [&](Certificate& c) { at(c).dimension = max_dimension + 1; });
      add(name + ": another reason", [&](Certificate& c) { (at(c).relation ? *at(c).relation : at(c).generator.index) += 1000; });
    });
    each<Certificate::ImpliedArc>(&Certificate::implied, "implied arc", [&](std::string const& name, auto const& at) {
      word(name, [at](Certificate& c) -> Word& { return at(c).arc.word; });
      trace(name, [at](Certificate& c) -> Vanishing& { return at(c).trace; });
      add(name + ": another dimension", [&](Certificate& c) { at(c).arc.dimension = max_dimension + 1; });
      add(name + ": one arc more", [&](Certificate& c) { at(c).evidence.arcs.push_back(0); });
      Certificate right = right_;
      if (at(right).evidence.kind == analysis::ImpliedEvidence::Kind::placement) walk(name, [at](Certificate& c) -> analysis::Walk& { return at(c).walk; });
    });
  }

  void mutate_conditions() {
    using Direction = Certificate::IncidentArcs::Direction;
    each<Certificate::IncidentArcs>(&Certificate::incident_arcs, "incident arcs", [&](std::string const& name, auto const& at) {
      Certificate right = right_;
      for (auto const direction : {&Certificate::IncidentArcs::out, &Certificate::IncidentArcs::in}) {
        if ((at(right).*direction).left != (at(right).*direction).right) {
          add(name + ": sides exchanged", [&](Certificate& c) { std::swap((at(c).*direction).left, (at(c).*direction).right); });
        }
        for (auto const side : {&Direction::left, &Direction::right}) {
          add(name + ": an arc more or less", [&](Certificate& c) {
            auto& arc = at(c).*direction.*side;
            if (arc) arc.reset();
            else arc = 0;
          });
          if (!(at(right).*direction.*side)) continue;
          index(name, [at, direction, side](Certificate& c) -> ArcIndex& { return *(at(c).*direction.*side); });
        }
      }
      add(name + ": another node", [&](Certificate& c) { ++at(c).node; });
      add(name + ": another dimension", [&](Certificate& c) { ++at(c).dimension; });
    });
    each<Certificate::Reverse>(&Certificate::reverses, "reverse", [&](std::string const& name, auto const& at) {
      add(name + ": the other side", [&](Certificate& c) { at(c).added = !at(c).added; });
      index(name, [at](Certificate& c) -> ArcIndex& { return at(c).arc; });
      index(name, [at](Certificate& c) -> ArcIndex& { return at(c).reverse; });
      proof(name, [at](Certificate& c) -> Proof& { return at(c).proof; });
    });
    each<Certificate::Cycle>(&Certificate::cycles, "cycle", [&](std::string const& name, auto const& at) {
      add(name + ": the other side", [&](Certificate& c) { at(c).added = !at(c).added; });
      for (std::size_t k = 0; k < 4; ++k) {
        index(name, [at, k](Certificate& c) -> ArcIndex& { return at(c).arcs[k]; });
      }
      Certificate right = right_;
      if (!at(right).proof) return;
      add(name + ": no proof", [&](Certificate& c) { at(c).proof.reset(); });
      proof(name, [at](Certificate& c) -> Proof& { return *at(c).proof; });
    });
    each<Certificate::Paths>(&Certificate::paths, "paths", [&](std::string const& name, auto const& at) {
      Certificate right = right_;
      for (auto const side : {&Certificate::Paths::left, &Certificate::Paths::right}) {
        add(name + ": shorter", [&](Certificate& c) { (at(c).*side).pop_back(); });
        for (std::size_t k = 0; k < (at(right).*side).size(); ++k) {
          index(name, [at, side, k](Certificate& c) -> ArcIndex& { return (at(c).*side)[k]; });
        }
      }
      proof(name, [at](Certificate& c) -> Proof& { return at(c).proof; });
    });
    each<Certificate::NoLoop>(&Certificate::no_loops, "no loop", [&](std::string const& name, auto const& at) {
      index(name, [at](Certificate& c) -> ArcIndex& { return at(c).arc; });
      word(name, [at](Certificate& c) -> Word& { return at(c).conjugation.by; });
      add(name + ": another letter", [&](Certificate& c) { ++at(c).conjugation.letter.dimension; });
      proof(name, [at](Certificate& c) -> Proof& { return at(c).proof; });
    });
  }

  Certificate const& right_;
  Letter extra_;
  std::vector<Mutant> all_{};
};

}  // namespace

std::vector<Mutant> mutants(Certificate const& certificate, Model const& model) { return Mutants(certificate, model).run(); }

}  // namespace jrule::certificate

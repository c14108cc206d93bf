// Everything is looked up in the lists of arcs again: no table, no normal form, no search.
#include "tests/certificate/checker.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace jrule::certificate {

namespace {

using analysis::ArcIndex;
using analysis::Certificate;
using ir::Arc;
using ir::NodeId;
using Arcs = std::vector<Arc>;

struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};
void demand(bool holds, std::string const& what) {
  if (!holds) throw Fault(what);
}

// ---- Words ----

class Words {
 public:
  explicit Words(Model const& model) : model_(model) {}

  bool oriented(int d) const { return ((model_.oriented >> d) & 1U) != 0; }
  bool exchange(int i, int j) const {
    return std::any_of(model_.exchange.begin(), model_.exchange.end(),
                       [&](auto const& pair) { return pair == std::pair(i, j) || pair == std::pair(j, i); });
  }
  Letter reverse(Letter letter) const { return {letter.dimension, oriented(letter.dimension) ? !letter.conjugate : letter.conjugate}; }
  Word reverse(Word const& word) const {
    Word result;
    for (auto letter = word.rbegin(); letter != word.rend(); ++letter) result.push_back(reverse(*letter));
    return result;
  }
  static Word join(std::initializer_list<Word> words) {
    Word all;
    for (Word const& word : words) all.insert(all.end(), word.begin(), word.end());
    return all;
  }

  /// Does the trace speak of this word, and empty it?
  void vanishes(Word word, analysis::Vanishing const& trace, std::string const& what) const {
    demand(trace.word == word, what + ": the trace is of another word");
    for (auto const& [left, right] : trace.steps) {
      demand(left < right && right < word.size(), what + ": a step outside of the word");
      for (std::size_t k = right; k > left + 1; --k) {  // x·y = ȳ·x̄
        demand(exchange(word[k - 1].dimension, word[k].dimension), what + ": letters that are not exchangeable change places");
        bool const both = oriented(word[k - 1].dimension) && oriented(word[k].dimension);
        demand(!both || word[k - 1].conjugate == word[k].conjugate, what + ": of (ij)² = ε letters change places of which one is conjugate");
        Letter const passed = reverse(word[k - 1]);
        word[k - 1] = reverse(word[k]);
        word[k] = passed;
      }
      demand(word[left + 1] == reverse(word[left]), what + ": letters cancel that are not inverse");
      word.erase(std::next(word.begin(), static_cast<std::ptrdiff_t>(left)), std::next(word.begin(), static_cast<std::ptrdiff_t>(left) + 2));
    }
    demand(word.empty(), what + ": the word is not emptied");
  }

 private:
  Model const& model_;
};

// ---- The certificate ----

class Checker {
 public:
  Checker(Certificate const& certificate, ir::RuleScheme const& rule) : c_(certificate), rule_(rule) {}

  void run() {
    check_placements();
    check_relations();
    check_closure();
    check_implied();
    check_incident_arcs();
    check_reverses();
    check_cycles();
    check_paths();
    check_all_covered();
    check_no_loops();
  }

 private:
  Model const& model() const { return rule_.model(); }
  Arcs const& side(bool added) const { return added ? right_ : left_; }
  Arc const& written(ArcIndex index) const {
    demand(index < rule_.left.arcs.size(), "an arc that is not on the left side");
    return rule_.left.arcs[index];
  }
  Arc const& arc(bool added, ArcIndex index) const {
    demand(index < side(added).size(), "an arc that is not there");
    return side(added)[index];
  }
  /// Is it added (deleted): not on the other side too?
  bool changed(bool added, ArcIndex index) const {
    Arc const& a = arc(added, index);
    return std::none_of(side(!added).begin(), side(!added).end(), [&](Arc const& b) {
      return std::tie(a.source, a.dimension, a.word, a.target) == std::tie(b.source, b.dimension, b.word, b.target);
    });
  }
  /// The arcs of a dimension that leave a node (enter it).
  std::vector<ArcIndex> incident(bool added, NodeId node, int dimension, bool out) const {
    std::vector<ArcIndex> found;
    for (ArcIndex k = 0; k < side(added).size(); ++k) {
      Arc const& a = side(added)[k];
      if (a.dimension == dimension && (out ? a.source : a.target) == node) found.push_back(k);
    }
    return found;
  }
  Letter letter(int dimension, bool backwards) const { return {static_cast<std::uint8_t>(dimension), backwards && words_.oriented(dimension)}; }
  /// The pattern is defined as closed under this word.
  Word word_of(analysis::Generator const& generator) const {
    using Kind = analysis::Generator::Kind;
    if (generator.kind == Kind::hook_type) {
      demand(generator.index < rule_.hook_type.size(), "a letter that the hook's type lacks");
      return {rule_.hook_type[generator.index]};
    }
    Arcs const& arcs = generator.kind == Kind::left_word ? rule_.left.arcs : rule_.right.arcs;
    demand(generator.index < arcs.size(), "the word of an arc that is not written");
    return arcs[generator.index].word;
  }
  void in_pattern(Word const& word, analysis::Walk const& walk) const {
    Word walked;
    for (auto const& [letter, generator, backwards] : walk.steps) {
      if (letter) demand(!backwards && closed_.contains(letter->dimension), "a step that may leave the pattern");
      Word const along = letter ? Word{*letter} : word_of(generator);
      walked = Words::join({walked, backwards ? words_.reverse(along) : along});
    }
    words_.vanishes(Words::join({walked, words_.reverse(word)}), walk.trace, "walk");
  }

  // ---- What the left side says ----

  Word const& offset(NodeId node) const {
    auto const found = offsets_.find(node);
    demand(found != offsets_.end(), "a node that is not placed");
    return found->second;
  }

  void check_placements() {
    if (!rule_.hooks.empty()) offsets_[rule_.hooks.front()] = {};
    for (auto const& [evidence, claimed, trace] : c_.placements) {
      Arc const& a = written(evidence.arc);
      demand(evidence.node == (evidence.forwards ? a.target : a.source), "an arc that does not place the node");
      Word const before = evidence.forwards ? words_.reverse(a.word) : a.word;
      Word const& from = offset(evidence.forwards ? a.source : a.target);
      Word const given = Words::join({before, from, {letter(a.dimension, !evidence.forwards)}});
      words_.vanishes(Words::join({given, words_.reverse(claimed)}), trace, "placement");
      demand(offsets_.emplace(evidence.node, claimed).second, "a node placed twice");
    }
  }

  Word around(Arc const& a) const {
    Word const &from = offset(a.source), &to = offset(a.target);
    return Words::join({from, {letter(a.dimension, false)}, words_.reverse(to), words_.reverse(a.word)});
  }

  void check_relations() const {
    using Kind = analysis::RelationEvidence::Kind;
    for (auto const& [evidence, word, trace] : c_.relations) {
      Word given;
      for (ArcIndex const index : evidence.arcs) given = Words::join({given, written(index).word});
      if (evidence.kind == Kind::arc) {
        demand(evidence.arcs.size() == 1, "a relation from one arc has one");
        given = around(written(evidence.arcs[0]));
      } else if (evidence.kind == Kind::arc_and_reverse) {
        demand(evidence.arcs.size() == 2, "an arc and its reverse are two");
        Arc const &a = written(evidence.arcs[0]), &b = written(evidence.arcs[1]);
        demand(a.dimension == b.dimension && !words_.oriented(a.dimension) && a.target == b.source && b.target == a.source, "arcs that are not reverse");
      } else if (evidence.kind == Kind::single_dart) {
        // The copies of a further hook are reached from one of them along its own loops: without any there is one copy.
        demand(evidence.arcs.empty() && evidence.hook > 0 && evidence.hook < rule_.hooks.size(), "a single dart is that of a further hook");
        NodeId const hook = rule_.hooks[evidence.hook];
        for (Arc const& a : rule_.left.arcs) demand(a.source != hook || a.target != hook || a.word.empty(), "a further hook with loops has more copies");
        given = word_of(evidence.generator);
      } else {
        demand(evidence.kind == Kind::cycle && evidence.arcs.size() == 4, "a cycle has four arcs");
        Arcs arcs;
        for (ArcIndex const index : evidence.arcs) arcs.push_back(written(index));
        demand(alternate(arcs) && arcs.back().target == arcs.front().source, "arcs that are no cycle");
      }
      words_.vanishes(Words::join({given, words_.reverse(word)}), trace, "relation");
    }
  }

  void check_closure() {
    for (auto const& [dimension, relation, generator] : c_.closure) {
      if (relation) demand(*relation < c_.relations.size(), "a relation that is not there");
      int here = 0;
      for (Letter const l : relation ? c_.relations[*relation].word : word_of(generator)) {
        if (l.dimension == dimension) ++here;
        else demand(closed_.contains(l.dimension), "a word that leaves the pattern elsewhere");
      }
      demand(here == 1, "a word in which the dimension does not occur once");
      closed_.insert(dimension);
    }
  }

  void check_implied() {
    using Kind = analysis::ImpliedEvidence::Kind;
    for (auto const& [implied, evidence, trace, walk] : c_.implied) {
      for (NodeId const node : {implied.source, implied.target}) {
        demand(node < rule_.nodes.size() && rule_.nodes[node].preserved(), "an implied arc of a node that is not preserved");
      }
      Arcs rests_on;
      Word given;
      for (ArcIndex const index : evidence.arcs) {
        rests_on.push_back(arc(false, index));
        given = Words::join({given, rests_on.back().word});
      }
      if (evidence.kind == Kind::reverse) {
        demand(rests_on.size() == 1 && rests_on[0].dimension == implied.dimension && !words_.oriented(implied.dimension) &&
                   rests_on[0].source == implied.target && rests_on[0].target == implied.source, "an implied arc that is no reverse");
      } else if (evidence.kind == Kind::cycle) {
        rests_on.push_back(implied);
        demand(rests_on.size() == 4 && alternate(rests_on) && implied.target == rests_on[0].source, "an implied arc that closes no cycle");
      } else {
        demand(evidence.kind == Kind::placement && rests_on.empty(), "an arc that is placed rests on no other");
        in_pattern(implied.word, walk);
      }
      given = Words::join({given, implied.word});
      if (evidence.kind == Kind::placement) given = around(implied);
      words_.vanishes(given, trace, "implied arc");
      left_.push_back(implied);
      right_.push_back(implied);
    }
  }

  void acts_as_identity(Word word, analysis::Proof const& proof, std::string const& what) const {
    demand(proof.word == word, what + ": the proof is of another word");
    for (auto const& step : proof.steps) {
      in_pattern(step.prefix, step.walk);
      demand(step.relation < c_.relations.size(), what + ": a relation that is not there");
      Word const& relation = c_.relations[step.relation].word;
      Word const inserted = step.conjugate ? words_.reverse(relation) : relation;
      words_.vanishes(Words::join({step.prefix, inserted, words_.reverse(step.prefix), word, words_.reverse(step.result)}), step.trace, what);
      word = step.result;
    }
    words_.vanishes(word, proof.trace, what);
  }

  // ---- The conditions ----

  void check_incident_arcs() const {
    std::set<std::pair<NodeId, int>> seen;
    for (auto const& entry : c_.incident_arcs) {
      demand(entry.node < rule_.nodes.size() && seen.emplace(entry.node, entry.dimension).second, "a node listed twice, or none");
      for (bool const out : {true, false}) {
        for (bool const added : {false, true}) {
          auto const& direction = out ? entry.out : entry.in;
          auto const found = incident(added, entry.node, entry.dimension, out);
          auto const& claimed = added ? direction.right : direction.left;
          demand(found == (claimed ? std::vector{*claimed} : std::vector<ArcIndex>{}), "not the arcs of the node");
          ir::Node const& node = rule_.nodes[entry.node];
          if (added ? node.added() : node.deleted()) demand(claimed.has_value(), "an added or deleted node lacks an arc");
          if (node.preserved()) demand(direction.left.has_value() == direction.right.has_value(), "a preserved node gains or loses an arc");
        }
      }
    }
    for (NodeId node = 0; node < rule_.nodes.size(); ++node) {
      for (int const d : model().dimensions) demand(seen.contains({node, d}), "a node without entry");
    }
    demand(seen.size() == rule_.nodes.size() * model().dimensions.size(), "an entry for no dimension of the model");
  }

  void check_reverses() {
    for (auto const& [added, index, reverse, proof] : c_.reverses) {
      Arc const &a = arc(added, index), &b = arc(added, reverse);
      demand(changed(added, index) && changed(added, reverse), "only one of an arc and its reverse changes");
      demand(a.dimension == b.dimension && !words_.oriented(a.dimension) && a.target == b.source && b.target == a.source, "arcs that are not reverse");
      acts_as_identity(Words::join({b.word, a.word}), proof, "reverse");
      reverse_of_[{added, index}] = reverse;
      reverse_of_[{added, reverse}] = index;
    }
  }

  /// Consecutive arcs, of two exchangeable dimensions in turn.
  bool alternate(Arcs const& arcs) const {
    for (std::size_t k = 1; k < arcs.size(); ++k) {
      if (arcs[k - 1].target != arcs[k].source || !words_.exchange(arcs[k - 1].dimension, arcs[k].dimension)) return false;
      if (k > 1 && arcs[k].dimension != arcs[k - 2].dimension) return false;
    }
    return true;
  }

  void cover(bool added, ArcIndex index, int i, int j) { covered_.insert({added, index, std::min(i, j), std::max(i, j)}); }

  void check_cycles() {
    for (auto const& [added, indices, proof] : c_.cycles) {
      Arcs arcs;
      for (ArcIndex const index : indices) arcs.push_back(arc(added, index));
      demand(alternate(arcs) && arcs[3].target == arcs[0].source, "arcs that are no cycle");
      for (ArcIndex const index : indices) cover(added, index, arcs[0].dimension, arcs[1].dimension);
      demand(proof.has_value() == added, "of the cycles those of the right side have to be proved");
      if (added) acts_as_identity(Words::join({arcs[0].word, arcs[1].word, arcs[2].word, arcs[3].word}), *proof, "cycle");
    }
  }

  /// The word of a maximal path of changed arcs in no cycle.
  Word check_path(bool added, std::vector<ArcIndex> const& indices, int i, int j) {
    Arcs arcs;
    Word word;
    for (ArcIndex const index : indices) {
      demand(changed(added, index), "a path through an arc that does not change");
      arcs.push_back(arc(added, index));
      demand(arcs.back().dimension == i || arcs.back().dimension == j, "a path of another dimension");
      word = Words::join({word, arcs.back().word});
      cover(added, index, i, j);
    }
    demand(!arcs.empty() && alternate(arcs), "arcs that are no path");
    for (ArcIndex const before : incident(added, arcs.front().source, i + j - arcs.front().dimension, false)) demand(!changed(added, before), "a path that starts earlier");
    int next = i + j - arcs.back().dimension;
    for (ArcIndex const after : incident(added, arcs.back().target, next, true)) demand(!changed(added, after), "a path that goes on");
    while (arcs.size() < 4) {  // and the preserved arcs behind it
      auto const onwards = incident(added, arcs.back().target, next, true);
      if (onwards.empty()) return word;
      arcs.push_back(arc(added, onwards.front()));
      next = i + j - next;
    }
    demand(arcs.back().target != arcs.front().source, "a path in a cycle");
    return word;
  }

  void check_paths() {
    for (auto const& [pair, left, right, proof] : c_.paths) {
      auto const [i, j] = pair;
      demand(words_.exchange(i, j), "a path of dimensions that are not exchangeable");
      Word const before = check_path(false, left, i, j), after = check_path(true, right, i, j);
      demand(left.size() == right.size() && arc(false, left.front()).dimension == arc(true, right.front()).dimension, "paths with other labels");
      demand(arc(false, left.front()).source == arc(true, right.front()).source && arc(false, left.back()).target == arc(true, right.back()).target,
             "paths with other ends");
      acts_as_identity(Words::join({before, words_.reverse(after)}), proof, "paths");
    }
  }

  void check_all_covered() const {
    for (bool const added : {false, true}) {
      for (ArcIndex index = 0; index < side(added).size(); ++index) {
        if (!changed(added, index)) continue;
        int const d = side(added)[index].dimension;
        auto const reverse = reverse_of_.find({added, index});
        demand(words_.oriented(d) || reverse != reverse_of_.end(), "a changed arc without reverse");
        for (auto const& [i, j] : model().exchange) {
          if (d != i && d != j) continue;
          // A cycle of non-oriented dimensions through the one is a cycle through the other, read backwards.
          bool const mirrored = !words_.oriented(i) && !words_.oriented(j) && covered_.contains({added, reverse->second, i, j});
          demand(covered_.contains({added, index, i, j}) || mirrored, "a changed arc in no cycle and no path");
        }
      }
    }
  }

  void check_no_loops() const {
    std::set<ArcIndex> seen;
    for (auto const& [index, conjugation, proof] : c_.no_loops) {
      demand(seen.insert(index).second, "a loop listed twice");
      Word const& by = conjugation.by;
      acts_as_identity(Words::join({arc(true, index).word, by, {words_.reverse(conjugation.letter)}, words_.reverse(by)}), proof, "loop");
      auto const& all = model().dimensions;
      demand(std::find(all.begin(), all.end(), conjugation.letter.dimension) != all.end(), "a letter that the model lacks");
    }
    for (ArcIndex index = 0; model().closed && index < right_.size(); ++index) {
      if (right_[index].source == right_[index].target && changed(true, index)) demand(seen.contains(index), "an added arc that may be a loop");
    }
  }

  Certificate const& c_;
  ir::RuleScheme const& rule_;
  Words words_{rule_.model()};
  Arcs left_{rule_.left.arcs}, right_{rule_.right.arcs};  // implied arcs are added as they are checked
  std::map<NodeId, Word> offsets_{};
  std::set<int> closed_{};
  std::map<std::pair<bool, ArcIndex>, ArcIndex> reverse_of_{};
  std::set<std::tuple<bool, ArcIndex, int, int>> covered_{};
};

}  // namespace

std::optional<std::string> fault(Certificate const& certificate, ir::RuleScheme const& rule) {
  try {
    Checker(certificate, rule).run();
    return {};
  } catch (Fault const& found) {
    return found.what();
  }
}

}  // namespace jrule::certificate

#include "compiler/analysis/placement.h"

namespace jrule::analysis {

Placement::Placement(ir::RuleScheme const& rule, algebra::Group const& group)
    : rule_(rule), group_(group), hook_(rule.nodes.size(), 0), offset_(rule.nodes.size()), evidence_(rule.nodes.size()) {
  std::vector<bool> placed(rule.nodes.size(), false);
  for (std::size_t h = 0; h < rule.hooks.size(); ++h) {
    placed[rule.hooks[h]] = true;
    hook_[rule.hooks[h]] = h;
    offset_[rule.hooks[h]] = Word{};
  }
  auto const place = [&](ir::NodeId node, ir::NodeId from, Word const& word, Letter letter) {
    // m(u, node) = m(u·word, from)·letter
    placed[node] = true;
    hook_[node] = hook_[from];
    auto const translated = translate(hook_[from], word);
    if (translated && offset_[from]) offset_[node] = group_.product(group_.product(*translated, *offset_[from]), {letter});
  };
  bool changed = true;
  while (changed) {
    changed = false;
    for (ArcIndex index = 0; index < rule.left.arcs.size(); ++index) {
      ir::Arc const& arc = rule.left.arcs[index];
      auto const d = static_cast<std::uint8_t>(arc.dimension);
      if (placed[arc.source] && !placed[arc.target]) {
        place(arc.target, arc.source, group_.inverse(arc.word), {d, false});
        evidence_[arc.target] = {arc.target, index, true};
      } else if (!placed[arc.source] && placed[arc.target]) {
        place(arc.source, arc.target, arc.word, {d, rule.model().is_oriented(arc.dimension)});
        evidence_[arc.source] = {arc.source, index, false};
      } else {
        continue;
      }
      changed = true;
    }
  }
}

std::optional<Word> Placement::translate(std::size_t hook, Word const& word) const {
  if (hook == 0) return word;
  ir::NodeId const node = rule_.hooks[hook];
  Word result;
  for (Letter const letter : word) {
    bool found = false;
    for (ir::Arc const& arc : rule_.left.arcs) {
      if (arc.source != node || arc.target != node || arc.word.size() != 1 || arc.word[0].dimension != letter.dimension) continue;
      // The loop (o, e) gives m(u·o) = m(u)·e; walked the other way, m(u·ō) = m(u)·ē.
      bool const backwards = arc.word[0].conjugate != letter.conjugate;
      result.push_back({static_cast<std::uint8_t>(arc.dimension), backwards && rule_.model().is_oriented(arc.dimension)});
      found = true;
      break;
    }
    if (!found) return {};
  }
  return group_.normal_form(result);
}

bool Placement::holds_everywhere(ir::Arc const& arc) const {
  std::size_t const h = hook_[arc.source];
  // A further hook's own loops are what its placement relies on, so they are tested, not assumed.
  if (h != 0 && arc.source == rule_.hooks[h] && arc.target == arc.source) return false;
  if (hook_[arc.target] != h || !offset_[arc.source] || !offset_[arc.target]) return false;
  auto const translated = translate(h, arc.word);
  if (!translated) return false;
  Word const reached = group_.product(*offset_[arc.source], {Letter{static_cast<std::uint8_t>(arc.dimension), false}});
  return reached == group_.product(*translated, *offset_[arc.target]);
}

}  // namespace jrule::analysis

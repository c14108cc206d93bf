#include "compiler/analysis/representative.h"

#include <algorithm>

namespace jrule::analysis {

namespace {

using ir::Builtin;
using ir::Expr;
using ir::ExprPtr;

/// What of the order of a list its reader depends on.
enum class Order {
  none,    ///< mean, sum, count, …
  cyclic,  ///< the sense of rotation: the area vector of a face
  exact,   ///< first
};

/// A dart read by an expression: of a node at the pattern dart, or bound by a comprehension, and a path from there.
struct Place {
  bool bound = false;
  std::size_t base = 0;  ///< the hook of the node's component; the variable's level
  Word word;             ///< from the hook's dart, offset included; from the bound dart
};

/// An expression at u beside another one, or itself, at u·g.
struct Comparison {
  ir::RuleScheme const& rule;
  algebra::Group const& group;
  Placement const& placement;
  PatternWords const& words;
  Word shift;                      // g
  std::vector<Word> bound_shift{};  // of each variable: the same dart, or where this word leads from it

  std::optional<Place> place(Expr const& dart, bool shifted) const {
    if (auto const* node = std::get_if<ir::NodeDart>(&dart.value)) {
      std::size_t const hook = placement.hook(node->node);
      auto const& offset = placement.offset(node->node);
      auto const moved = placement.translate(hook, shifted ? shift : Word{});
      if (!offset || !moved) return {};
      return Place{false, hook, group.product(*moved, *offset)};
    }
    if (auto const* bound = std::get_if<ir::Bound>(&dart.value)) {
      return Place{true, bound->level, shifted ? bound_shift.at(bound->level) : Word{}};
    }
    if (auto const* walk = std::get_if<ir::Walk>(&dart.value)) {
      auto from = place(*walk->from, shifted);
      if (from) from->word = group.product(from->word, walk->path);
      return from;
    }
    return {};
  }

  // The word that leads from the one to the other, if they are read from one dart.
  std::optional<Word> between(Expr const& a, Expr const& b) const {
    auto const from = place(a, false), to = place(b, true);
    if (!from || !to || from->bound != to->bound || from->base != to->base) return {};
    // u·v = u·w for all u: the left side may force it.
    if (!from->bound && from->base == 0 && words.equal(from->word, to->word)) return Word{};
    return group.product(group.inverse(from->word), to->word);
  }

  bool same_dart(Expr const& a, Expr const& b) const {
    auto const word = between(a, b);
    return word && word->empty();
  }

  bool same_orbit(Expr const& a, Expr const& b, OrbitType const& orbit) const {
    auto const word = between(a, b);
    return word && group.in_orbit(*word, orbit);
  }

  // The sense of rotation turns with each letter of a non-oriented dimension; all relations have an even number of them.
  bool same_sense(Expr const& a, Expr const& b) const {
    auto const word = between(a, b);
    return word && std::count_if(word->begin(), word->end(), [&](Letter l) { return !group.model().is_oriented(l.dimension); }) % 2 == 0;
  }

  bool same_darts(ir::Darts const& a, ir::Darts const& b, Order order) const {
    if (a.orbit != b.orbit || a.by != b.by) return false;
    if (same_dart(*a.at, *b.at)) return true;
    return order != Order::exact && same_orbit(*a.at, *b.at, a.orbit) && (order == Order::none || same_sense(*a.at, *b.at));
  }

  // A comprehension takes one dart of each ⟨by⟩-orbit, which one depends on where it starts: then its element has to be the same at
  // all of them.
  bool same_comprehension(ir::ForEach const& a, ir::ForEach const& b, Order order) const {
    bool const start = same_dart(*a.over.at, *b.over.at);
    if (!same_darts(a.over, b.over, order == Order::none ? order : Order::exact)) return false;
    Comparison inner = *this;
    inner.bound_shift.resize(std::max(a.variable.level, b.variable.level) + 1);
    inner.bound_shift[a.variable.level] = {};
    if (a.variable.level != b.variable.level || !inner.same(*a.element, *b.element, order)) return false;
    if (start) return true;
    inner.shift = {};
    return std::all_of(a.over.by.words.begin(), a.over.by.words.end(), [&](Word const& h) {
      inner.bound_shift[a.variable.level] = h;
      return inner.same(*a.element, *a.element, Order::none);
    });
  }

  static bool commutes(Builtin f) {
    switch (f) {
      case Builtin::add: case Builtin::multiply: case Builtin::equal: case Builtin::not_equal: case Builtin::logical_and:
      case Builtin::logical_or: case Builtin::dot: case Builtin::midpoint: case Builtin::distance: case Builtin::min: case Builtin::max:
        return true;
      default: return false;
    }
  }

  // Of x + (y + z) all three; and so of the other associative operations.
  static std::vector<ExprPtr> operands(ir::Apply const& apply) {
    bool const associative = apply.function == Builtin::add || apply.function == Builtin::multiply || apply.function == Builtin::logical_and ||
                             apply.function == Builtin::logical_or || apply.function == Builtin::min || apply.function == Builtin::max;
    std::vector<ExprPtr> all;
    for (ExprPtr const& argument : apply.arguments) {
      auto const* const inner = std::get_if<ir::Apply>(&argument->value);
      if (associative && inner && inner->function == apply.function && inner->arguments.size() == apply.arguments.size()) {
        for (ExprPtr& operand : operands(*inner)) all.push_back(std::move(operand));
      } else {
        all.push_back(argument);
      }
    }
    return all;
  }

  bool same_applications(ir::Apply const& a, ir::Apply const& b) const {
    if (a.function != b.function || a.arguments.size() != b.arguments.size()) return false;
    Order const order = a.function == Builtin::first ? Order::exact : a.function == Builtin::area_vector ? Order::cyclic : Order::none;
    if (!commutes(a.function) || a.arguments.size() < 2) {
      return std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(),
                        [&](ExprPtr const& x, ExprPtr const& y) { return same(*x, *y, order); });
    }
    auto const left = operands(a);
    auto right = operands(b);
    if (left.size() != right.size()) return false;
    return std::all_of(left.begin(), left.end(), [&](ExprPtr const& x) {
      auto const found = std::find_if(right.begin(), right.end(), [&](ExprPtr const& y) { return same(*x, *y, Order::none); });
      if (found == right.end()) return false;
      right.erase(found);
      return true;
    });
  }

  /// Is a at u the same as b at u·g?
  bool same(Expr const& a, Expr const& b, Order order) const {
    if (!(a.type == b.type)) return false;
    if (a.type.dart && !a.type.list) return same_dart(a, b);
    if (a.value.index() != b.value.index()) return false;
    return std::visit([&](auto const& x) { return same_value(x, std::get<std::decay_t<decltype(x)>>(b.value), order); }, a.value);
  }

  bool same_value(ir::Constant const& a, ir::Constant const& b, Order) const { return a.value == b.value; }
  bool same_value(ir::ParameterRef const& a, ir::ParameterRef const& b, Order) const { return a.index == b.index; }
  bool same_value(ir::LetRef const& a, ir::LetRef const& b, Order) const { return a.index == b.index; }  // evaluated at the hooks
  bool same_value(ir::NodeDart const&, ir::NodeDart const&, Order) const { return false; }               // darts: see same
  bool same_value(ir::Bound const&, ir::Bound const&, Order) const { return false; }
  bool same_value(ir::Walk const&, ir::Walk const&, Order) const { return false; }
  bool same_value(ir::Darts const& a, ir::Darts const& b, Order order) const { return same_darts(a, b, order); }
  bool same_value(ir::ValueAt const& a, ir::ValueAt const& b, Order) const {
    return a.embedding == b.embedding && same_orbit(*a.at, *b.at, rule.modeler->embeddings[a.embedding].orbit);
  }
  bool same_value(ir::Collect const& a, ir::Collect const& b, Order order) const {
    return a.embedding == b.embedding && same_darts(a.over, b.over, order);
  }
  bool same_value(ir::ForEach const& a, ir::ForEach const& b, Order order) const { return same_comprehension(a, b, order); }
  bool same_value(ir::Apply const& a, ir::Apply const& b, Order) const { return same_applications(a, b); }
  bool same_value(ir::Conditional const& a, ir::Conditional const& b, Order order) const {
    return same(*a.condition, *b.condition, Order::none) && same(*a.then_value, *b.then_value, order) && same(*a.else_value, *b.else_value, order);
  }

  /// The first innermost part that is not the same.
  Expr const* culprit(Expr const& e, Order order) const {
    if (same(e, e, order)) return nullptr;
    std::vector<ExprPtr> parts;
    if (auto const* apply = std::get_if<ir::Apply>(&e.value)) {
      parts = apply->arguments;
      order = apply->function == Builtin::first ? Order::exact : apply->function == Builtin::area_vector ? Order::cyclic : Order::none;
    }
    if (auto const* choice = std::get_if<ir::Conditional>(&e.value)) parts = {choice->condition, choice->then_value, choice->else_value};
    for (ExprPtr const& part : parts) {
      if (Expr const* const found = culprit(*part, order)) return found;
    }
    return &e;
  }
};

}  // namespace

Expr const* RepresentativeCheck::changed_by(Expr const& value, Word const& g) const {
  return Comparison{rule_, group_, placement_, words_, g}.culprit(value, Order::exact);
}

}  // namespace jrule::analysis

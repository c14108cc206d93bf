#include "compiler/analysis/representative.h"

#include <algorithm>

namespace jrule::analysis {

namespace {

using ir::Builtin;
using ir::Expr;
using ir::ExprPtr;

/// What of a list, apart from which values are in it, its reader depends on; of each one also on what comes before.
enum class Order {
  shares,  ///< how many of its values are a given one, in proportion: mean, min, all, …
  none,    ///< how many: sum, count
  cyclic,  ///< the sense of rotation: the area vector of a face
  exact,   ///< first
};

/// A dart read by an expression: of a node at the pattern dart, bound by a comprehension or given by a `let`; and a path from there.
struct Place {
  enum class From { node, bound, let } from = From::node;
  std::size_t base = 0;  ///< the hook of the node's component; the variable's level; the let
  Word word;             ///< from the hook's dart, offset included; from the bound or given dart

  bool beside(Place const& other) const { return from == other.from && base == other.base; }
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
      return Place{Place::From::node, hook, group.product(*moved, *offset)};
    }
    if (auto const* bound = std::get_if<ir::Bound>(&dart.value)) {
      return Place{Place::From::bound, bound->level, shifted ? bound_shift.at(bound->level) : Word{}};
    }
    if (auto const* let = std::get_if<ir::LetRef>(&dart.value)) return Place{Place::From::let, let->index, {}};  // the hooks'
    if (auto const* walk = std::get_if<ir::Walk>(&dart.value)) {
      auto from = place(*walk->from, shifted);
      if (from) from->word = group.product(from->word, walk->path);
      return from;
    }
    return {};
  }

  // The word that leads from the one to the other, if they are read from one dart.
  std::optional<Word> between(Place const& from, Place const& to) const {
    if (!from.beside(to)) return {};
    if (of_pattern(from) && words.equal(from.word, to.word)) return Word{};
    return group.product(group.inverse(from.word), to.word);
  }
  std::optional<Word> between(Expr const& a, Expr const& b) const {
    auto const from = place(a, false), to = place(b, true);
    return from && to ? between(*from, *to) : std::nullopt;
  }

  // The left side may force u·v = u·w for all pattern darts u.
  static bool of_pattern(Place const& place) { return place.from == Place::From::node && place.base == 0; }

  bool same_dart(Expr const& a, Expr const& b) const {
    auto const word = between(a, b);
    return word && word->empty();
  }

  bool same_orbit(Place const& from, Place const& to, OrbitType const& orbit) const {
    auto const word = between(from, to);
    if (!word) return false;
    if (group.in_orbit(*word, orbit)) return true;
    return of_pattern(from) && std::any_of(orbit.words.begin(), orbit.words.end(), [&](Word const& h) {
             return words.equal(group.product(from.word, h), to.word);
           });
  }
  bool same_orbit(Expr const& a, Expr const& b, OrbitType const& orbit) const {
    auto const from = place(a, false), to = place(b, true);
    return from && to && same_orbit(*from, *to, orbit);
  }

  // The elements of an orbit of at most two dimensions, where all maps have the same; none else.
  std::vector<Word> elements(OrbitType const& orbit) const {
    std::vector<Word> all{Word{}};
    for (Word const& word : orbit.words) {
      if (!group.is_identity(group.product(word, word)) || orbit.words.size() > 2) return {};
      for (std::size_t k = all.size(); k-- > 0;) all.push_back(group.product(all[k], word));
    }
    bool const commute = orbit.words.size() < 2 || group.product(orbit.words[0], orbit.words[1]) == group.product(orbit.words[1], orbit.words[0]);
    return commute ? all : std::vector<Word>{};
  }

  // Are there as many darts in the one list as in the other? Either there is one, or where paths of the orbit meet from the one
  // dart, they do so from the other.
  bool same_number(ir::Darts const& darts, Place const& from, Place const& to) const {
    auto const all = [](OrbitType const& orbit, auto const& holds) { return std::all_of(orbit.words.begin(), orbit.words.end(), holds); };
    if (all(darts.orbit, [&](Word const& o) { return group.in_orbit(o, darts.by); })) return true;
    auto const between_them = between(from, to);
    auto const commutes = [&](Word const& o) { return group.product(*between_them, o) == group.product(o, *between_them); };
    return between_them && all(darts.orbit, commutes) && all(darts.by, commutes);
  }

  // Dart by dart, the values of both orbits are the same. In each of the two, as many paths lead to any dart as to any other.
  bool same_elements(ir::Darts const& a, ir::Darts const& b, OrbitType const& value_orbit, Order order) const {
    auto const from = place(*a.at, false), to = place(*b.at, true);
    auto const all = elements(a.orbit);
    if (order > Order::none || !from || !to || all.empty() || a.orbit != b.orbit || a.by != b.by) return false;
    if (order == Order::none && !same_number(a, *from, *to)) return false;
    return std::all_of(all.begin(), all.end(), [&](Word const& o) {
      Place x = *from, y = *to;
      x.word = group.product(x.word, o);
      y.word = group.product(y.word, o);
      return same_orbit(x, y, value_orbit);
    });
  }

  // The sense of rotation turns with each letter of a non-oriented dimension; all relations have an even number of them.
  bool same_sense(Expr const& a, Expr const& b) const {
    auto const word = between(a, b);
    return word && std::count_if(word->begin(), word->end(), [&](Letter l) { return !group.model().is_oriented(l.dimension); }) % 2 == 0;
  }

  // A letter that commutes with all words of ⟨orbit⟩ and ⟨by⟩ takes the orbit of a dart, dart by dart, to that of the dart where it
  // leads. Where it also takes each dart to one with the same value (`keeps`), the two orbits have the same values.
  template <typename Keeps>
  OrbitType with_neighbours(ir::Darts const& darts, Keeps const& keeps) const {
    OrbitType result = darts.orbit;
    for (int const d : group.model().dimensions) {
      Word const letter{{static_cast<std::uint8_t>(d), false}};
      auto const commute = [&](Word const& word) { return group.product(letter, word) == group.product(word, letter); };
      auto const all_commute = [&](OrbitType const& orbit) { return std::all_of(orbit.words.begin(), orbit.words.end(), commute); };
      if (all_commute(darts.orbit) && all_commute(darts.by) && keeps(letter)) result.words.push_back(letter);
    }
    return result;
  }

  template <typename Keeps>
  bool same_darts(ir::Darts const& a, ir::Darts const& b, Order order, Keeps const& keeps) const {
    if (a.orbit != b.orbit || a.by != b.by) return false;
    if (same_dart(*a.at, *b.at)) return true;
    if (order == Order::exact) return false;
    if (order == Order::cyclic) return same_orbit(*a.at, *b.at, a.orbit) && same_sense(*a.at, *b.at);
    return same_orbit(*a.at, *b.at, with_neighbours(a, keeps));
  }

  // A comprehension takes one dart of each ⟨by⟩-orbit, which one depends on where it starts: then its element has to be the same at
  // all of them.
  bool same_comprehension(ir::ForEach const& a, ir::ForEach const& b, Order order) const {
    std::size_t const level = a.variable.level;
    if (level != b.variable.level) return false;
    Comparison inner = *this;
    inner.bound_shift.resize(level + 1);
    inner.bound_shift[level] = {};
    if (!inner.same(*a.element, *b.element, order)) return false;
    if (same_dart(*a.over.at, *b.over.at)) return a.over.orbit == b.over.orbit && a.over.by == b.over.by;
    inner.shift = {};
    auto const keeps = [&](Word const& word) {
      inner.bound_shift[level] = word;
      return inner.same(*a.element, *a.element, Order::none);
    };
    return order <= Order::none && same_darts(a.over, b.over, order, keeps) &&
           std::all_of(a.over.by.words.begin(), a.over.by.words.end(), keeps);
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

  // Of the lists among its arguments. Of an area vector that is read only for its length, the sense of rotation plays no part.
  static Order order_of(ir::Apply const& apply) {
    switch (apply.function) {
      case Builtin::first: return Order::exact;
      case Builtin::area_vector: return Order::cyclic;
      case Builtin::mean: case Builtin::min: case Builtin::max: case Builtin::all: case Builtin::any: return Order::shares;
      default: return Order::none;
    }
  }
  bool same_length(Expr const& a, Expr const& b) const {
    auto const *x = std::get_if<ir::Apply>(&a.value), *y = std::get_if<ir::Apply>(&b.value);
    return x && y && x->function == Builtin::area_vector && y->function == Builtin::area_vector && same(*x->arguments[0], *y->arguments[0], Order::none);
  }

  // d == e says that the path from d to e returns to its dart: that of a word is said by its conjugates, backwards too.
  std::optional<Place> loop(ir::Apply const& equality, bool shifted) const {
    auto from = place(*equality.arguments[0], shifted);
    auto const to = place(*equality.arguments[1], shifted);
    if (!from || !to || !from->beside(*to)) return {};
    from->word = group.product(from->word, group.inverse(to->word));
    return from;
  }
  bool same_loops(ir::Apply const& a, ir::Apply const& b) const {
    bool const equality = a.function == Builtin::equal || a.function == Builtin::not_equal;
    if (!equality || !(a.arguments[0]->type == ir::dart_type) || !(b.arguments[0]->type == ir::dart_type)) return false;
    auto const x = loop(a, false), y = loop(b, true);
    return x && y && x->beside(*y) && (x->word == y->word || x->word == group.inverse(y->word));
  }

  bool same_applications(ir::Apply const& a, ir::Apply const& b) const {
    if (same_loops(a, b) && a.function == b.function) return true;
    if (a.function != b.function || a.arguments.size() != b.arguments.size()) return false;
    if (a.function == Builtin::norm && same_length(*a.arguments[0], *b.arguments[0])) return true;
    Order const order = order_of(a);
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
  bool same_value(ir::VariableRef const&, ir::VariableRef const&, Order) const { return false; }  // of operations
  bool same_value(ir::CopyOf const&, ir::CopyOf const&, Order) const { return false; }
  bool same_value(ir::Darts const& a, ir::Darts const& b, Order order) const {  // they are counted
    return same_darts(a, b, order, [](Word const&) { return true; });
  }
  bool same_value(ir::ValueAt const& a, ir::ValueAt const& b, Order) const {
    return a.embedding == b.embedding && same_orbit(*a.at, *b.at, rule.modeler->embeddings[a.embedding].orbit);
  }
  // As a comprehension, it takes one dart of each ⟨by⟩-orbit: unless it starts at the same dart, all of those have to have its value.
  bool same_value(ir::Collect const& a, ir::Collect const& b, Order order) const {
    OrbitType const& orbit = rule.modeler->embeddings[a.embedding].orbit;
    if (a.embedding != b.embedding) return false;
    auto const keeps = [&](Word const& word) { return group.in_orbit(word, orbit); };
    if (!same_dart(*a.over.at, *b.over.at) && !std::all_of(a.over.by.words.begin(), a.over.by.words.end(), keeps)) return false;
    return same_elements(a.over, b.over, orbit, order) || same_darts(a.over, b.over, order, keeps);
  }
  bool same_value(ir::ForEach const& a, ir::ForEach const& b, Order order) const { return same_comprehension(a, b, order); }
  bool same_value(ir::Apply const& a, ir::Apply const& b, Order) const { return same_applications(a, b); }
  // A function of a list is trusted not to mind its order.
  bool same_value(ir::Call const& a, ir::Call const& b, Order) const {
    return a.function == b.function && std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(),
                                                  [&](ExprPtr const& x, ExprPtr const& y) { return same(*x, *y, Order::none); });
  }
  bool same_value(ir::Conditional const& a, ir::Conditional const& b, Order order) const {
    return same(*a.condition, *b.condition, Order::none) && same(*a.then_value, *b.then_value, order) && same(*a.else_value, *b.else_value, order);
  }

  /// The first innermost part that is not the same.
  Expr const* culprit(Expr const& e, Order order) const {
    if (same(e, e, order)) return nullptr;
    auto const* const apply = std::get_if<ir::Apply>(&e.value);
    bool const call = std::holds_alternative<ir::Call>(e.value);
    // What reads the map is told whole.
    if (!apply && !call && !std::holds_alternative<ir::Conditional>(e.value)) return &e;
    if (apply) order = order_of(*apply);
    if (call) order = Order::none;
    for (ExprPtr const& part : ir::parts(e)) {
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

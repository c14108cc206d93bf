#include "compiler/jerboa/translate.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compiler/jerboa/tokens.h"

namespace jrule::jerboa {

namespace {

using enum Value::Level;
using Kind = Token::Kind;

constexpr int depth_limit = 100;
constexpr std::size_t length_limit = 1500;  // bytes: variables may double a value again and again; and it keeps the parser's limits

// Thrown and caught in this file only: a parser of expressions gives up at any depth.
struct GiveUp {
  Untranslated what;
};

class Translator {
 public:
  Translator(std::string const& code, Scope const& scope) : tokens_(tokens_of(code)), scope_(scope) {}

  std::string run(Type type) {
    while (true) {
      if (take("return") || !statement()) return result(type);
    }
  }

 private:
  // ---- Tokens ----

  Token const& token(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  bool is(std::string_view text, std::size_t ahead = 0) const {
    return (token(ahead).kind == Kind::sign || token(ahead).kind == Kind::name) && token(ahead).text == text;
  }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view text) {
    if (!take(text)) unknown();
  }
  [[noreturn]] void give_up(std::size_t first, std::string reason) const {
    std::size_t const last = std::max(first, at_ == 0 ? 0 : at_ - 1);
    throw GiveUp{{tokens_[first].begin, tokens_[std::min(last, tokens_.size() - 1)].end, std::move(reason)}};
  }
  [[noreturn]] void unknown() const {
    std::string const what = token().kind == Kind::end ? "it ends where an expression goes on" : fmt::format("`{}` is not expected there", token().text);
    throw GiveUp{{token().begin, token().end, what}};
  }
  /// The value, where there is one; `first` is where its code begins.
  Value take_value(std::size_t first, Translated<Value> value) const {
    if (!value) give_up(first, value.error().text);
    if (value->text.size() > length_limit) give_up(first, "it is too long");
    return std::move(*value);
  }

  // ---- Statements ----

  std::string result(Type type) {
    std::size_t const start = at_;
    Value const value = take_value(start, convert(expression(), type));
    take(";");
    if (token().kind != Kind::end) unknown();
    return value.text;
  }

  /// False, and nothing taken, if an expression stands there.
  bool statement() {
    std::size_t const start = at_;
    if (take(";")) return true;
    if (token().kind == Kind::name && variables_.contains(token().text)) return variable_statement();
    std::string const type = type_name();
    if (type.empty() || token().kind != Kind::name) {
      at_ = start;
      return false;
    }
    auto const name = std::string(token().text);
    ++at_;
    if (take("=")) {
      Value const value = expression();
      variables_[name] = type_of(type) == Type::real ? real_of(value) : value;
    } else if (take("(")) {
      variables_[name] = take_value(start, construct(type, arguments()));
    } else {
      if (!is(";")) unknown();
      variables_[name] = take_value(start, construct(type, {}));
    }
    expect(";");
    return true;
  }

  /// Ints that are converted are divided as Reals.
  static Value real_of(Value value) {
    if (value.kind == Value::Kind::plain && value.type == Type::integer) value.type = Type::real;
    value.constant.reset();
    return value;
  }

  // `v = E;`, `v.barycenter(E);`, `v += E;`
  bool variable_statement() {
    std::size_t const start = at_;
    Value& variable = variables_.find(token().text)->second;
    ++at_;
    if (take("=")) {
      variable = expression();
    } else if (take("+=")) {
      variable = take_value(start, add(variable, expression()));
    } else if (take("-=")) {
      variable = take_value(start, subtract(variable, expression()));
    } else if (is(".") && is("(", 2) && (is("barycenter", 1) || is("middle", 1) || is("add", 1))) {
      bool const sum = is("add", 1);
      at_ += 3;
      auto const values = arguments();
      // What it was before does not count for a mean.
      if (!is(";")) {
        at_ = start;
        return false;
      }
      if (sum) variable = take_value(start, add(variable, displacement(start, values)));
      else variable = take_value(start, call("mean", values));
    } else {
      at_ = start;
      return false;
    }
    expect(";");
    return true;
  }

  /// `Vec3`, `fr.lias.Vec3`, `List<Vec3>`, `Vec3*`; empty if none stands there.
  std::string type_name() {
    std::string name;
    while (token().kind == Kind::name && !is("new")) {
      name += token().text;
      ++at_;
      if (!is(".") || token(1).kind != Kind::name) break;
      name += '.';
      ++at_;
    }
    if (!name.empty() && is("<") && token(1).kind == Kind::name) skip_template();
    if (!name.empty() && (is("*") || is("&"))) ++at_;
    return name;
  }

  void skip_template() {
    expect("<");
    while (token().kind == Kind::name || is(".") || is(",") || is("*")) ++at_;
    expect(">");
  }

  // ---- Expressions ----

  Value expression() {
    if (++depth_ > depth_limit) throw GiveUp{{token().begin, token().end, "it is nested too deeply"}};
    std::size_t const start = at_;
    Value value = binary(0);
    if (take("?")) {
      Value const condition = take_value(start, convert(value, Type::boolean));
      Value const yes = expression();
      expect(":");
      Value const no = expression();
      value = conditional_value(start, condition, yes, no);
    }
    --depth_;
    return value;
  }

  Value conditional_value(std::size_t start, Value const& condition, Value yes, Value no) {
    if (yes.kind == Value::Kind::tuple && no.kind == Value::Kind::tuple) give_up(start, "both cases are coordinates, of a place or of a displacement");
    if (yes.kind == Value::Kind::tuple) yes = take_value(start, convert(yes, no.type));
    Type const type = no.kind == Value::Kind::plain && yes.type == Type::integer ? no.type : yes.type;
    yes = take_value(start, convert(yes, type));
    no = take_value(start, convert(no, type));
    return plain(fmt::format("if {} then {} else {}", at_level(condition, disjunction), at_level(yes, disjunction), at_level(no, disjunction)), type, conditional);
  }

  /// Binary operators, from the loosest.
  Value binary(std::size_t level) {
    static std::vector<std::vector<std::string_view>> const levels = {{"||"}, {"&&"}, {"==", "!="}, {"<", "<=", ">", ">="}, {"+", "-"}, {"*", "/"}};
    if (level == levels.size()) return prefix();
    std::size_t const start = at_;
    Value value = binary(level + 1);
    while (true) {
      auto const sign = std::find_if(levels[level].begin(), levels[level].end(), [&](std::string_view text) { return is(text); });
      if (sign == levels[level].end()) return value;
      ++at_;
      Value const right = binary(level + 1);
      value = take_value(start, apply(*sign, value, right));
    }
  }

  static Translated<Value> apply(std::string_view sign, Value const& a, Value const& b) {
    if (sign == "+") return add(a, b);
    if (sign == "-") return subtract(a, b);
    if (sign == "*") return multiply(a, b);
    if (sign == "/") return divide(a, b);
    if (sign != "||" && sign != "&&") return compare(sign, a, b);
    auto const left = convert(a, Type::boolean), right = convert(b, Type::boolean);
    if (!left) return tl::unexpected(left.error());
    if (!right) return tl::unexpected(right.error());
    if (sign == "||") return plain(fmt::format("{} or {}", at_level(*left, disjunction), at_level(*right, conjunction)), Type::boolean, disjunction);
    return plain(fmt::format("{} and {}", at_level(*left, conjunction), at_level(*right, negation)), Type::boolean, conjunction);
  }

  Value prefix() {
    if (++depth_ > depth_limit) throw GiveUp{{token().begin, token().end, "it is nested too deeply"}};
    std::size_t const start = at_;
    Value value;
    if (take("-")) {
      value = take_value(start, negate(prefix()));
    } else if (take("+") || take("*")) {
      value = prefix();  // `*`: C++ reaches values of embeddings by pointers
    } else if (take("!")) {
      Value const operand = take_value(start, convert(prefix(), Type::boolean));
      value = plain("not " + at_level(operand, negation), Type::boolean, negation);
    } else if (auto const type = cast()) {
      Value const operand = prefix();
      value = *type == Type::real ? real_of(operand) : take_value(start, construct(name_of(*type), {operand}));
    } else {
      value = suffixes(start, primary());
    }
    --depth_;
    return value;
  }

  /// `(float)`, `(Vec3*)`. Nothing is taken if there is none.
  std::optional<Type> cast() {
    std::size_t const start = at_;
    if (take("(") && token().kind == Kind::name) {
      auto const type = type_of(type_name());
      bool const operand = take(")") && (token().kind == Kind::name || token().kind == Kind::integer || token().kind == Kind::real || is("("));
      if (type && operand && *type != Type::integer) return type;
    }
    at_ = start;
    return std::nullopt;
  }

  Value primary() {
    std::size_t const start = at_;
    Token const& first = token();
    if (first.kind == Kind::integer || first.kind == Kind::real) return number();
    if (take("(")) {
      Value value = expression();
      expect(")");
      return value;
    }
    if (take("new")) {
      std::string const type = type_name();
      expect("(");
      auto const values = arguments();
      return take_value(start, construct(type, values));
    }
    if (is("<")) return orbit_values();
    if (first.kind != Kind::name) unknown();
    if (take("true")) return plain("true", Type::boolean);
    if (take("false")) return plain("false", Type::boolean);
    if (auto const variable = variables_.find(first.text); variable != variables_.end()) {
      ++at_;
      return variable->second;
    }
    if (scope_.nodes.contains(first.text)) return dart();
    if (auto const parameter = scope_.parameters.find(first.text); parameter != scope_.parameters.end() && !is("(", 1)) {
      ++at_;
      return plain(parameter->second.name, parameter->second.type);
    }
    return function_or_constant();
  }

  Value number() {
    Token const& literal = token();
    ++at_;
    if (literal.kind == Kind::integer) {
      std::int64_t value = 0;
      auto const [stop, error] = std::from_chars(literal.text.data(), literal.text.data() + literal.text.size(), value);
      bool const octal = literal.text.size() > 1 && literal.text[0] == '0';
      if (error != std::errc() || octal) give_up(at_ - 1, fmt::format("`{}` is no decimal number that fits", literal.text));
      Value result = plain(std::to_string(value), Type::integer);
      result.constant = value;
      return result;
    }
    double value = 0;
    auto const [stop, error] = std::from_chars(literal.text.data(), literal.text.data() + literal.text.size(), value);
    if (error != std::errc()) give_up(at_ - 1, "the number is too large");
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return plain(text, Type::real);
  }

  // `mid(a, b)`, `Vec3.mid(a, b)`, `Vec3(1, 0, 0)`, `Math.PI`
  Value function_or_constant() {
    std::size_t const start = at_;
    std::string_view qualifier, name = token().text;
    std::string path(name);
    ++at_;
    while (is(".") && token(1).kind == Kind::name) {
      qualifier = name;
      name = token(1).text;
      path += fmt::format(".{}", name);
      at_ += 2;
    }
    if (take("(")) {
      auto const values = arguments();
      return take_value(start, type_of(path) ? construct(path, values) : call(name, values));
    }
    if (auto const value = constant(qualifier, name)) return *value;
    if (qualifier.empty()) give_up(start, fmt::format("`{}` is neither a node of the left side, nor a parameter, nor a variable", path));
    give_up(start, fmt::format("`{}` is not known", path));
  }

  std::vector<Value> arguments() {
    std::vector<Value> values;
    if (take(")")) return values;
    do values.push_back(expression());
    while (take(","));
    expect(")");
    return values;
  }

  /// What is added by `v.add(w)`, `v.addn(1, 0, 0)`.
  Value displacement(std::size_t start, std::vector<Value> const& values) const {
    if (values.size() == 1) return values[0];
    if (values.size() != 2 && values.size() != 3) give_up(start, "what is added is neither a vector nor its components");
    return tuple(values);
  }

  // ---- The map ----

  // `n0`, `n0()`, `n0@0@1`, `n0.alpha(0)`
  Value dart() {
    std::string name = scope_.nodes.find(token().text)->second;
    ++at_;
    if (is("(") && is(")", 1)) at_ += 2;
    std::string path;
    auto const step = [&] {
      if (token().kind != Kind::integer) unknown();
      path += fmt::format("{}{}", path.empty() ? "" : ",", token().text);
      ++at_;
    };
    while (true) {
      if (take("@")) {
        step();
      } else if (is(".") && is("alpha", 1) && is("(", 2)) {
        at_ += 3;
        step();
        expect(")");
      } else {
        break;
      }
    }
    if (path.size() == 1) name += "@" + path;
    if (path.size() > 1) name += "@[" + path + "]";
    return {.kind = Value::Kind::dart, .text = name};
  }

  // `<0,1>_pos(n0)`
  Value orbit_values() {
    std::size_t const start = at_;
    expect("<");
    std::string orbit;
    while (token().kind == Kind::integer) {
      orbit += fmt::format("{}{}", orbit.empty() ? "" : ",", token().text);
      ++at_;
      if (!take(",")) break;
    }
    expect(">");
    if (token().kind != Kind::name || token().text[0] != '_') unknown();
    std::string_view const name = token().text.substr(1);
    auto const embedding = scope_.embeddings.find(name);
    ++at_;
    if (embedding == scope_.embeddings.end()) give_up(start, fmt::format("there is no embedding `{}` here", name));
    expect("(");
    Value const center = expression();
    expect(")");
    if (center.kind != Value::Kind::dart) give_up(start, "the orbit is not that of a node");
    return {.kind = Value::Kind::list, .text = fmt::format("<{}>({}).{}", orbit, center.text, embedding->second.name), .type = embedding->second.type};
  }

  // `.pos`, `.ebd("pos")`, `.<Vec3>ebd("pos")`, `.addn(0, 0, 1)`, `.norm()`, `.x`
  Value suffixes(std::size_t start, Value value) {
    while (is(".")) {
      ++at_;
      if (is("<")) skip_template();
      if (token().kind != Kind::name) unknown();
      std::string_view const name = token().text;
      ++at_;
      if (value.kind == Value::Kind::dart) {
        value = embedding_at(start, value, name);
      } else if (take("(")) {
        value = method(start, value, name, arguments());
      } else {
        value = component(start, value, name);
      }
    }
    return value;
  }

  Value embedding_at(std::size_t start, Value const& dart, std::string_view name) {
    if (name == "ebd" && is("(") && token(1).kind == Kind::string && is(")", 2)) {
      name = token(1).text;
      at_ += 3;
    }
    auto const embedding = scope_.embeddings.find(name);
    if (embedding == scope_.embeddings.end()) give_up(start, fmt::format("there is no embedding `{}` here", name));
    return plain(fmt::format("{}.{}", dart.text, embedding->second.name), embedding->second.type);
  }

  Value component(std::size_t start, Value const& value, std::string_view name) const {
    static constexpr std::string_view xyz = "xyz", rgb = "rgb";
    bool const plain_value = value.kind == Value::Kind::plain;
    bool const of_color = plain_value && value.type == Type::color && rgb.find(name) != std::string_view::npos;
    bool const flat = value.type == Type::vec2 || value.type == Type::point2;
    bool const spatial = plain_value && value.type >= Type::vec2 && value.type <= Type::point3;
    bool const of_vector = spatial && (flat ? xyz.substr(0, 2) : xyz).find(name) != std::string_view::npos;
    if (name.size() != 1 || !(of_color || of_vector)) give_up(start, fmt::format("`{}` is not known", name));
    return plain(fmt::format("{}.{}", at_level(value, postfix), name), Type::real);
  }

  // Those that leave the value as it is: `add` changes it.
  Value method(std::size_t start, Value const& value, std::string_view name, std::vector<Value> const& values) const {
    if (name == "addn" || name == "plus") return take_value(start, add(value, displacement(start, values)));
    if (name == "subn" || name == "minus") return take_value(start, subtract(value, displacement(start, values)));
    bool const coordinate = values.empty() && name.size() == 1;
    if (coordinate) return component(start, value, name);
    std::vector<Value> all{value};
    all.insert(all.end(), values.begin(), values.end());
    if (name == "dot" || name == "cross" || name == "dist" || name == "distance" || name == "norm" || name == "length") return take_value(start, call(name, all));
    give_up(start, fmt::format("`{}` has no counterpart", name));
  }

  std::vector<Token> tokens_;
  Scope const& scope_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::map<std::string, Value, std::less<>> variables_;
};

}  // namespace

tl::expected<std::string, Untranslated> translate(std::string const& code, Scope const& scope, Type type) {
  try {
    return Translator(code, scope).run(type);
  } catch (GiveUp const& given_up) {
    return tl::unexpected(given_up.what);
  }
}

}  // namespace jrule::jerboa

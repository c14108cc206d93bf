#include "compiler/driver/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace jrule::driver {

namespace {

template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

std::optional<Value> parse_value(Type type, std::string_view text) {
  if (type == Type::Bool) {
    if (text == "true") return Value(true);
    if (text == "false") return Value(false);
    return {};
  }
  if (type == Type::Int) {
    auto const number = parse_number<std::int64_t>(text);
    return number ? std::optional<Value>(*number) : std::nullopt;
  }
  std::string const name = jrule::to_string(type);
  if (text.starts_with(name)) text.remove_prefix(name.size());
  if (text.starts_with('(') && text.ends_with(')')) text = text.substr(1, text.size() - 2);
  std::vector<double> components;
  while (true) {
    std::size_t const comma = text.find(',');
    auto const number = parse_number<double>(text.substr(0, comma));
    if (!number || !std::isfinite(*number)) return {};
    components.push_back(*number);
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  if (components.size() != static_cast<std::size_t>(component_count(type))) return {};
  return from_components(type, components);
}

std::string example(Type type) {
  switch (type) {
    case Type::Bool: return "true";
    case Type::Int: return "3";
    case Type::Real: return "0.5";
    default: return component_count(type) == 2 ? "0,1" : "0,0,1";
  }
}

}  // namespace

Result<std::vector<Value>> parse_arguments(ir::RuleScheme const& rule, std::vector<std::string> const& arguments) {
  auto const error = [](std::string message) { return fail(Error::Kind::bad_input, std::move(message)); };
  std::vector<std::optional<Value>> values;
  std::vector<std::string> names;
  for (ir::Parameter const& p : rule.parameters) {
    values.push_back(p.default_value);
    names.push_back(p.name);
  }
  std::vector<bool> given(values.size(), false);
  for (std::string const& argument : arguments) {
    std::size_t const equals = argument.find('=');
    if (equals == std::string::npos) return error(fmt::format("`{}` is not of the form NAME=VALUE", argument));
    std::string const name = argument.substr(0, equals);
    std::size_t at = 0;
    while (at < names.size() && names[at] != name) ++at;
    if (at == names.size()) {
      return error(names.empty() ? fmt::format("`{}` has no parameters, so none called `{}`", rule.name, name)
                                 : fmt::format("`{}` has no parameter `{}`; it has `{}`", rule.name, name, fmt::join(names, "`, `")));
    }
    if (given[at]) return error(fmt::format("the parameter `{}` is given twice", name));
    given[at] = true;
    Type const type = rule.parameters[at].type;
    values[at] = parse_value(type, std::string_view(argument).substr(equals + 1));
    if (!values[at]) {
      return error(fmt::format("`{}` is not a {}: write `{}={}`", argument.substr(equals + 1), jrule::to_string(type), name, example(type)));
    }
  }
  std::vector<Value> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) {
      return error(fmt::format("the parameter `{}` of `{}` is missing: write `{}={}`", names[i], rule.name, names[i], example(rule.parameters[i].type)));
    }
    result.push_back(*values[i]);
  }
  return result;
}

}  // namespace jrule::driver

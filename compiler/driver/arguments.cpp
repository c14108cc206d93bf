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

Result<std::vector<std::optional<Value>>> parse_arguments(std::string const& rule, std::vector<NamedType> const& parameters,
                                                          std::vector<std::string> const& arguments) {
  auto const error = [](std::string message) { return fail(Error::Kind::bad_input, std::move(message)); };
  std::vector<std::optional<Value>> values(parameters.size());
  std::vector<std::string> names;
  for (NamedType const& p : parameters) names.push_back(p.name);
  for (std::string const& argument : arguments) {
    std::size_t const equals = argument.find('=');
    if (equals == std::string::npos) return error(fmt::format("`{}` is not of the form NAME=VALUE", argument));
    std::string const name = argument.substr(0, equals);
    std::size_t at = 0;
    while (at < names.size() && names[at] != name) ++at;
    if (at == names.size()) {
      return error(names.empty() ? fmt::format("`{}` has no parameters, so none called `{}`", rule, name)
                                 : fmt::format("`{}` has no parameter `{}`; it has `{}`", rule, name, fmt::join(names, "`, `")));
    }
    if (values[at]) return error(fmt::format("the parameter `{}` is given twice", name));
    Type const type = parameters[at].type;
    values[at] = parse_value(type, std::string_view(argument).substr(equals + 1));
    if (!values[at]) {
      return error(fmt::format("`{}` is not {} {}: write `{}={}`", argument.substr(equals + 1), type == Type::Int ? "an" : "a",
                               jrule::to_string(type), name, example(type)));
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] || parameters[i].has_default) continue;
    return error(fmt::format("the parameter `{}` of `{}` is missing: write `{}={}`", names[i], rule, names[i], example(parameters[i].type)));
  }
  return values;
}

Result<std::vector<Value>> parse_arguments(ir::RuleScheme const& rule, std::vector<std::string> const& arguments) {
  std::vector<NamedType> parameters;
  for (ir::Parameter const& p : rule.parameters) parameters.push_back({p.name, p.type, p.default_value.has_value()});
  auto const given = parse_arguments(rule.name, parameters, arguments);
  if (!given) return tl::unexpected(given.error());
  std::vector<Value> values;
  for (std::size_t i = 0; i < given->size(); ++i) values.push_back((*given)[i] ? *(*given)[i] : *rule.parameters[i].default_value);
  return values;
}

}  // namespace jrule::driver

#include "compiler/backend/cpp/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace jrule::cpp {

std::string type_name(Type type) {
  switch (type) {
    case Type::Bool: return "bool";
    case Type::Int: return "std::int64_t";
    case Type::Real: return "double";
    case Type::Vec2:
    case Type::Vec3:
    case Type::Point2:
    case Type::Point3:
    case Type::Color:
    case Type::Extern: break;
  }
  return "jrule::" + to_string(type);
}

std::string type_name(ir::ExprType const& type) {
  std::string const element = type.dart       ? "jrule::Dart"
                              : type.external ? "::" + type.external->cpp_name
                                              : type_name(type.element);
  if (!type.list) return element;
  // A list of Bool is a list of bytes.
  return fmt::format("std::vector<{}>", type == ir::ExprType{Type::Bool, true} ? "std::uint8_t" : element);
}

std::string stored_type(ir::ExprType const& type) {
  return type == ir::ExprType{Type::Bool} ? "std::uint8_t" : type_name(type);
}

std::string parameter_type(ir::ExprType const& type) {
  return type_name(type) + (type.list || type.external ? " const&" : "");
}

std::string literal(double value) {
  if (std::isnan(value)) return "std::numeric_limits<double>::quiet_NaN()";
  if (std::isinf(value))
    return value > 0 ? "std::numeric_limits<double>::infinity()" : "-std::numeric_limits<double>::infinity()";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string literal(Value const& value) {
  if (auto const* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (auto const* i = std::get_if<std::int64_t>(&value)) {
    // The least integer has no literal: its opposite is out of range.
    if (*i == std::numeric_limits<std::int64_t>::min()) return "std::numeric_limits<std::int64_t>::min()";
    return fmt::format("std::int64_t{{{}}}", *i);
  }
  if (auto const* x = std::get_if<double>(&value)) return literal(*x);
  Type const type = type_of(value);
  std::string components;
  for (int k = 0; k < component_count(type); ++k) components += (k == 0 ? "" : ", ") + literal(component(value, k));
  return fmt::format("{}{{{}}}", type_name(type), components);
}

std::string literal(std::string_view text) {
  std::string result = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string initializer(Word const& word) {
  std::string text = "{";
  for (Letter const letter : word) {
    text += fmt::format("{}{{{}, {}}}", text.size() == 1 ? "" : ", ", letter.dimension, letter.conjugate);
  }
  return text + '}';
}

std::string orbit_expression(OrbitType const& orbit) {
  bool const dimensions = std::all_of(orbit.words.begin(), orbit.words.end(),
                                      [](Word const& w) { return w.size() == 1 && !w[0].conjugate; });
  std::string text;
  for (Word const& word : orbit.words) {
    text += (text.empty() ? "" : ", ") + (dimensions ? std::to_string(word[0].dimension) : initializer(word));
  }
  return dimensions ? fmt::format("jrule::orbit_of_dimensions({{{}}})", text)
                    : fmt::format("jrule::OrbitType{{{{{}}}}}", text);
}

std::string name_part(Word const& word) {
  std::string text;
  for (Letter const letter : word)
    text += fmt::format("{}{}{}", text.empty() ? "" : "_", letter.conjugate ? "b" : "", letter.dimension);
  return text;
}

std::string file_name(source::Sources const& sources, source::Span span) {
  if (span.file == source::no_file) return "unknown";
  std::string const& path = sources.file(span.file).path;
  std::string name = path.substr(path.find_last_of("/\\") + 1);
  // A comment must not end early or go on.
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\\'; }, '_');
  return name;
}

std::string place(source::Sources const& sources, source::Span span) {
  if (span.file == source::no_file) return "unknown";
  return fmt::format("{}:{}", file_name(sources, span), sources.position(span.file, span.begin).line);
}

std::string arc_text(ir::RuleScheme const& rule, ir::NodeId source, int dimension, Word const& word,
                     ir::NodeId target) {
  std::string letters;
  for (Letter const letter : word)
    letters += fmt::format("{}{}{}", letters.empty() ? "" : ",", letter.conjugate ? "~" : "", letter.dimension);
  if (!letters.empty()) letters = '[' + letters + ']';
  return fmt::format("{} -{}{}-> {}", rule.nodes[source].name, dimension, letters, rule.nodes[target].name);
}

std::vector<std::string> documentation(std::string_view doc) {
  std::vector<std::string> lines;
  while (!doc.empty()) {
    std::size_t const end = std::min(doc.find('\n'), doc.size());
    std::string line(doc.substr(0, end));
    // A backslash at the end would make the next line part of the comment.
    while (!line.empty() && (line.back() == '\\' || std::isspace(static_cast<unsigned char>(line.back())) != 0))
      line.pop_back();
    lines.push_back(std::move(line));
    doc.remove_prefix(std::min(end + 1, doc.size()));
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace jrule::cpp

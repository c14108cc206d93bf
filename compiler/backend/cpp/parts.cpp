#include "compiler/backend/cpp/parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

std::string remark(std::string const& doc) {
  auto const lines = documentation(doc);
  return lines.empty() ? "" : ": " + lines.front();
}

std::string default_of(ir::Parameter const& parameter) {
  return parameter.default_value ? literal(*parameter.default_value) : constant_expression(*parameter.computed_default);
}

std::string document_parameter(ir::Parameter const& parameter, std::string const& name) {
  std::string const unit = parameter.unit.empty() ? "" : " in " + parameter.unit;
  std::string by_default;
  if (parameter.default_value) by_default = ", by default " + to_string(*parameter.default_value);
  if (parameter.computed_default) by_default = ", by default " + constant_expression(*parameter.computed_default);
  return fmt::format("/// @param {}  {}{}{}{}", name, to_string(parameter.value_type()), unit, by_default, remark(parameter.doc));
}

void open_call(Writer& out, std::string const& start, std::vector<std::string> const& list, std::string const& end, bool opens) {
  std::string const line = fmt::format("{}({}){}", start, fmt::join(list, ", "), end);
  std::string const text = line.size() <= 110 ? line : fmt::format("{}({}){}", start, fmt::join(list, ",\n        "), end);
  opens ? out.open("{}", text) : out.line("{}", text);
}

void close_function(Writer& out, std::string const& name) {
  for (char const* error : {"bad_alloc", "length_error"}) {
    out.reopen("}} catch (std::{} const&) {{", error);
    out.line("return tl::unexpected(jrule::rewrite::no_memory({}));", literal(name));
  }
  out.close();
}

}  // namespace jrule::cpp

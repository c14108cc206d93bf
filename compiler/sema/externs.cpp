#include "compiler/sema/externs.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "compiler/sema/application.h"
#include "compiler/sema/overloads.h"
#include "compiler/sema/types.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostics;
using source::Span;

namespace {

bool is_identifier(std::string_view text) {
  auto const is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  auto const is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && !is_digit(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return is_letter(c) || is_digit(c); });
}

// "geo::Soil": identifiers with `::` between them.
bool is_qualified_name(std::string_view text) {
  for (std::size_t end = text.find("::"); end != std::string_view::npos; end = text.find("::")) {
    if (!is_identifier(text.substr(0, end))) return false;
    text.remove_prefix(end + 2);
  }
  return is_identifier(text);
}

// A path that stands between quotes after #include.
bool is_header(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) >= ' ' && c != '"' && c != '\\';
  });
}

struct Collection {
  Diagnostics& diagnostics;
  Externs result{};

  void report(Code code, Span span, std::string message, std::vector<std::string> notes = {}) {
    diagnostics.add({.code = code, .span = span, .message = std::move(message), .notes = std::move(notes)});
  }

  template <class Item>
  bool check_cpp(Item const& item, std::string const& what) {
    bool const header = is_header(item.header), name = is_qualified_name(item.cpp_name);
    if (!header) {
      report(Code::bad_extern, item.header_span, fmt::format("this is no header of {}", what),
             {"it is the path that stands after `#include`, without its quotes: `in \"geo/soil.hpp\"`"});
    }
    if (!name) {
      report(Code::bad_extern, item.cpp_name_span, fmt::format("this is no C++ name of {}", what),
             {"it is a name with its namespaces: `as \"geo::Soil\"`; anything else gets one by `using` in its header"});
    }
    return header && name;
  }

  void add(ast::ExternType const& item) {
    std::string const& name = item.name.text;
    bool good = check_cpp(item, fmt::format("the extern type `{}`", name));
    if (name == "Dart" || find_type(name)) {
      report(Code::duplicate_name, item.name.span, fmt::format("`{}` is a type of the language already", name));
      good = false;
    }
    result.types[name] = good ? std::make_shared<ir::ExternType const>(
                                    ir::ExternType{name, item.doc, item.header, item.cpp_name, item.name.span})
                              : nullptr;
  }

  void add(ast::ExternFunction const& item) {
    std::string const& name = item.name.text;
    bool good = check_cpp(item, fmt::format("the extern function `{}`", name));
    if (find_function(name)) {
      report(Code::duplicate_name, item.name.span, fmt::format("`{}` is a function of the language already", name));
      good = false;
    }
    ir::ExternFunction function{name, item.doc, {}, {}, item.header, item.cpp_name, item.name.span};
    for (ast::Parameter const& p : item.parameters) {
      auto const type = resolve_type(p.type, result, diagnostics);
      if (p.default_value) {
        report(Code::bad_extern, p.default_value->span,
               fmt::format("`{}` of the extern function `{}` has a default", p.name.text, name),
               {"a call of an extern function gives all of its arguments"});
      }
      auto const& known = function.parameters;
      bool const fresh =
          std::none_of(known.begin(), known.end(), [&](auto const& other) { return other.name == p.name.text; });
      if (!fresh)
        report(Code::duplicate_name, p.name.span, fmt::format("the parameter `{}` is declared twice", p.name.text));
      good = good && type && !p.default_value && fresh;
      if (type) function.parameters.push_back({p.name.text, *type, p.name.span});
    }
    auto const type = resolve_type(item.result, result, diagnostics);
    if (type) function.result = *type;
    result.functions[name] = good && type ? std::make_shared<ir::ExternFunction const>(std::move(function)) : nullptr;
  }
};

template <class Map>
std::vector<std::string> keys(Map const& map) {
  std::vector<std::string> names;
  for (auto const& [name, value] : map) names.push_back(name);
  return names;
}

}  // namespace

std::vector<std::string> Externs::type_names() const { return keys(types); }
std::vector<std::string> Externs::function_names() const { return keys(functions); }

Externs collect_externs(Modules const& modules, Diagnostics& diagnostics) {
  Collection collection{diagnostics};
  // Types first: a function may stand before the types that it names.
  for (Module const& module : modules.all) {
    for (ast::Item const& item : module.ast.items) {
      if (auto const* type = std::get_if<ast::ExternType>(&item)) collection.add(*type);
    }
  }
  for (Module const& module : modules.all) {
    for (ast::Item const& item : module.ast.items) {
      if (auto const* function = std::get_if<ast::ExternFunction>(&item)) collection.add(*function);
    }
  }
  return std::move(collection.result);
}

ir::ExprPtr call_extern(ir::ExternFunctionPtr function, Span name, std::vector<ir::ExprPtr> arguments, Span span,
                        Diagnostics& diagnostics) {
  auto const& parameters = function->parameters;
  if (arguments.size() != parameters.size()) {
    diagnostics.add({.code = Code::argument_count,
                     .span = name,
                     .message = fmt::format("`{}` takes {} argument{}, not {}", function->name, parameters.size(),
                                            parameters.size() == 1 ? "" : "s", arguments.size()),
                     .labels = {{function->span, fmt::format("declared as `{}`", ir::signature(*function))}}});
    return {};
  }
  bool good = true;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!is_taken_as(arguments[i]->type, parameters[i].type)) {
      diagnostics.add({.code = Code::type_mismatch,
                       .span = arguments[i]->span,
                       .message = fmt::format("`{}` of `{}` is {}, this is {}", parameters[i].name, function->name,
                                              described(parameters[i].type), described(arguments[i]->type)),
                       .labels = {{parameters[i].span, "declared here"}}});
      good = false;
      continue;
    }
    arguments[i] = convert(std::move(arguments[i]), parameters[i].type, diagnostics);
  }
  if (!good) return {};
  ir::ExprType const type = function->result;
  return std::make_shared<ir::Expr const>(ir::Expr{type, ir::Call{std::move(function), std::move(arguments)}, span});
}

}  // namespace jrule::sema

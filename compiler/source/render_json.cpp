// A diagnostic for programs. The only file that knows the JSON library.
#include <nlohmann/json.hpp>

#include "compiler/source/place.h"

namespace jrule::source {

namespace {

using Json = nlohmann::ordered_json;

/// Adds file line column endLine endColumn; null where there is no such place.
void add_place(Json& object, Sources const& sources, Span span) {
  auto const* file = file_of(sources, span);
  auto const range = range_of(sources, span);
  auto const number = [&](std::size_t value) { return range ? Json(value) : Json(nullptr); };
  auto const [begin, end] = range.value_or(Range{});
  object["file"] = file != nullptr ? Json(file->path) : Json(nullptr);
  object["line"] = number(begin.line);
  object["column"] = number(begin.column);
  object["endLine"] = number(end.line);
  object["endColumn"] = number(end.column);
}

}  // namespace

std::string render_json(Sources const& sources, Diagnostic const& diagnostic) {
  auto const& code = info(diagnostic.code);
  Json object;
  object["schema"] = 1;
  object["code"] = code.number;
  object["severity"] = word(severity(diagnostic));
  object["message"] = diagnostic.message;
  add_place(object, sources, diagnostic.span);
  object["notes"] = diagnostic.notes;
  object["labels"] = Json::array();
  for (auto const& label : diagnostic.labels) {
    Json entry{{"message", label.text}};
    add_place(entry, sources, label.span);
    object["labels"].push_back(std::move(entry));
  }
  object["fixits"] = Json::array();
  for (auto const& fixit : diagnostic.fixits) {
    Json entry{{"message", fixit.text}, {"replacement", fixit.replacement}};
    add_place(entry, sources, fixit.span);
    object["fixits"].push_back(std::move(entry));
  }
  // Text that is not UTF-8, a path perhaps, must not make the report fail.
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace jrule::source

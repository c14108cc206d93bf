#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

namespace {

bool is_part_of_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

}  // namespace

bool mentions(std::string_view text, std::string_view name) {
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at).starts_with("//")) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text[at] == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
      }
      ++at;
    } else if (is_part_of_name(text[at])) {
      std::size_t const begin = at;
      while (at < text.size() && is_part_of_name(text[at])) ++at;
      bool const is_member = begin > 0 && (text[begin - 1] == '.' || text[begin - 1] == ':');
      if (!is_member && text.substr(begin, at - begin) == name) return true;
    } else {
      ++at;
    }
  }
  return false;
}

void write_with_locals(Writer& out, std::vector<Local> const& locals, std::string const& text) {
  std::vector<Local const*> needed;
  std::string seen = text;
  for (auto local = locals.rbegin(); local != locals.rend(); ++local) {
    if (!mentions(seen, local->name)) continue;
    needed.push_back(&*local);
    seen += local->line;
  }
  for (auto local = needed.rbegin(); local != needed.rend(); ++local) out.text((*local)->line);
  out.lines(text);
}

std::vector<Local> map_locals(Function const& f) {
  std::vector<Local> locals{{f.map, fmt::format("jrule::Map& {} = {}.map();", f.map, f.modeler)},
                            {f.workspace, fmt::format("jrule::rewrite::Workspace& {} = {}.workspace();", f.workspace, f.modeler)}};
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    locals.push_back({f.embeddings[e], fmt::format("jrule::Embedding& {} = {}.embedding({});", f.embeddings[e], f.map, e)});
  }
  return locals;
}

std::vector<Local> view_locals(Function const& f) {
  std::vector<Local> locals;
  for (auto const& [types, name] : f.walks) {
    std::string const by = types.second.words.empty() ? "{}" : orbit_expression(types.second);
    locals.push_back({name, fmt::format("static jrule::rewrite::OrbitWalk const {}({}.model(), {}, {});", name, f.map,
                                        orbit_expression(types.first), by)});
  }
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    locals.push_back({f.values[e], fmt::format("jrule::rewrite::Values<{}> const {}({});", type_name(f.rule.modeler->value_type(e)),
                                               f.values[e], f.embeddings[e])});
  }
  return locals;
}

}  // namespace jrule::cpp

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  for (auto const& [letter, name] : f.steps) {
    if (letter.conjugate && !f.rule.model().is_oriented(letter.dimension)) continue;  // the same column
    locals.push_back({name, fmt::format("jrule::Dart const* const {} = {}.{}({}).data();", name, f.map,
                                        letter.conjugate ? "sources" : "targets", letter.dimension)});
  }
  return locals;
}

namespace {

// What visits one dart for each ⟨by⟩-orbit inside an orbit of a type: by its shape, without a set where that can be.
void add_walk(std::vector<Local>& locals, Function const& f, OrbitType const& type, OrbitType const& by, std::string const& name) {
  auto const add = [&](std::string const& kind, std::string const& arguments) {
    locals.push_back({name, fmt::format("jrule::rewrite::{} const {}{};", kind, name, arguments)});
  };
  auto const column = [&](Word const& word) { return f.steps.at(word.front()); };
  auto const& words = type.words;
  bool const each = by.words.empty();
  if (words.empty() || type == by) return add("DartWalk", "{}");
  if (words.size() == 1 && each) {
    if (f.is_involution(words[0])) return add("EdgeWalk", fmt::format("({})", column(words[0])));
    std::vector<std::string> columns;
    for (Letter const letter : words[0]) columns.push_back(f.steps.at(letter));
    return add(fmt::format("CycleWalk<{}>", columns.size()), fmt::format("({{{}}})", fmt::join(columns, ", ")));
  }
  if (words.size() == 2 && f.is_involution(words[0]) && f.is_involution(words[1])) {
    char const* kind = nullptr;
    if (each) kind = "dart";
    if (by == OrbitType{{words[0]}}) kind = "first";
    if (by == OrbitType{{words[1]}}) kind = "second";
    if (kind != nullptr) {
      return add(fmt::format("DihedralWalk<jrule::rewrite::By::{}>", kind), fmt::format("({}, {})", column(words[0]), column(words[1])));
    }
  }
  std::string const &walked = f.local(name + "_type"), &parts = f.local(name + "_parts");
  locals.push_back({walked, fmt::format("static jrule::OrbitType const {} = {};", walked, orbit_expression(type))});
  locals.push_back({parts, fmt::format("static jrule::OrbitType const {}{};", parts, each ? "{}" : " = " + orbit_expression(by))});
  add("OrbitWalk", fmt::format("({}, {}, {})", f.map, walked, parts));
}

// The orbits of the pattern under some words, and the first dart of each.
void add_orbits(std::vector<Local>& locals, Function const& f, std::vector<Word> const& generators, std::string const& name) {
  std::vector<std::string> columns;
  for (Word const& word : generators) columns.push_back(f.columns.at(word));
  auto const add = [&](std::string const& kind, std::string const& arguments) {
    locals.push_back({name, fmt::format("jrule::rewrite::{} const {}({});", kind, name, arguments)});
  };
  if (generators.size() == 1) {
    add("CycleOrbits", columns[0]);
  } else if (generators.size() == 2 && f.is_involution(generators[0]) && f.is_involution(generators[1])) {
    add("DihedralOrbits", fmt::format("{}", fmt::join(columns, ", ")));
  } else {
    std::string const& list = f.local(name + "_columns");
    locals.push_back({list, fmt::format("jrule::rewrite::Index const* const {}[] = {{{}}};", list, fmt::join(columns, ", "))});
    add("PatternOrbits", fmt::format("{}, {}, {}", f.size, list, f.workspace));
  }
  std::string const& first = f.firsts.at(generators);
  locals.push_back({first, fmt::format("jrule::rewrite::Index const* const {} = jrule::rewrite::first_of_orbits({}, {}, {});", first,
                                       name, f.size, f.workspace)});
}

}  // namespace

std::vector<Local> view_locals(Function const& f) {
  std::vector<Local> locals;
  for (auto const& [types, name] : f.walks) add_walk(locals, f, types.first, types.second, name);
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    locals.push_back({f.values[e], fmt::format("jrule::rewrite::Values<{}> const {}({});", type_name(f.rule.modeler->value_type(e)),
                                               f.values[e], f.embeddings[e])});
  }
  for (auto const& [generators, name] : f.orbits) add_orbits(locals, f, generators, name);
  return locals;
}

}  // namespace jrule::cpp

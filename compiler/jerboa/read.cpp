// The only file that knows pugixml.
#include "compiler/jerboa/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <initializer_list>
#include <pugixml.hpp>
#include <string_view>
#include <utility>

#include "compiler/syntax/text_fault.h"

namespace jrule::jerboa {

using source::Code;
using pugi::xml_node;

namespace {

constexpr std::size_t file_limit = 16U << 20U;  // bytes
constexpr int highest_dimension = 9;

std::uint32_t narrow(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

/// The bytes in the file, and in the text, of what stands at the begin of `raw`: of one byte, or of an entity.
std::pair<std::size_t, std::size_t> step(std::string_view raw) {
  if (raw[0] != '&') return {1, 1};
  for (std::string_view const entity : {"&lt;", "&gt;", "&amp;", "&quot;", "&apos;"}) {
    if (raw.starts_with(entity)) return {entity.size(), 1};
  }
  std::size_t const end = raw.find(';');
  if (!raw.starts_with("&#") || end == std::string_view::npos) return {1, 1};
  bool const hexadecimal = raw.size() > 2 && raw[2] == 'x';
  std::string_view const digits = raw.substr(hexadecimal ? 3 : 2, end - (hexadecimal ? 3 : 2));
  std::uint32_t code_point = 0;
  auto const [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code_point, hexadecimal ? 16 : 10);
  if (error != std::errc() || stop != digits.data() + digits.size()) return {1, 1};
  return {end + 1, code_point < 0x80 ? 1U : code_point < 0x800 ? 2U : code_point < 0x10000 ? 3U : 4U};
}

std::optional<int> to_int(std::string_view text) {
  int value = 0;
  auto const [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  std::size_t const begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// Entities can stand for what is no text.
void make_text(std::string& text) {
  std::size_t at = 0;
  while (auto const fault = syntax::find_text_fault(std::string_view(text).substr(at))) {
    at += fault->offset;
    text[at] = '?';
  }
}

class Reader {
 public:
  Reader(source::Sources const& sources, source::FileId file, source::Diagnostics& diagnostics)
      : text_(sources.file(file).text), file_(file), diagnostics_(diagnostics) {}

  std::optional<Modeler> run();

 private:
  // ---- Places ----

  Span span_of(xml_node element) const {
    auto const begin = narrow(static_cast<std::size_t>(element.offset_debug()));
    return {file_, begin, begin + narrow(std::string_view(element.name()).size())};
  }
  Span span_of(xml_node element, std::string_view attribute) const;
  void report(Code code, Span span, std::string message, std::vector<std::string> notes = {}) {
    diagnostics_.add({.code = code, .span = span, .message = std::move(message), .notes = std::move(notes)});
  }

  // ---- Parts of all elements ----

  /// The elements inside; those with other names than these are reported and left out.
  std::vector<xml_node> inside(xml_node element, std::initializer_list<std::string_view> known);
  xml_node required_child(xml_node element, char const* name);
  bool has(xml_node element, char const* attribute);
  Name attribute(xml_node element, char const* name);
  int number(xml_node element, char const* name, int least, int greatest);
  Orbit orbit(xml_node element, bool may_remove);
  Snippet code(xml_node element);

  // ---- The elements ----

  void read_modeler(xml_node element, Modeler& modeler);
  Embedding read_embedding(xml_node element);
  Rule read_rule(xml_node element);
  Script read_script(xml_node element);
  Side read_side(xml_node element, std::string const& rule);
  Node read_node(xml_node element);
  Arc read_arc(xml_node element, Side const& side, std::string const& rule);
  std::vector<Parameter> read_parameters(xml_node element);
  std::vector<std::string> read_hooks(xml_node element);

  std::string_view text_;
  source::FileId file_;
  source::Diagnostics& diagnostics_;
};

Span Reader::span_of(xml_node element, std::string_view attribute) const {
  // pugixml knows the places of elements only; the tag is well-formed.
  std::size_t at = static_cast<std::size_t>(element.offset_debug()) + std::string_view(element.name()).size();
  while (true) {
    std::size_t const name = text_.find_first_not_of(" \t\r\n", at);
    if (name == std::string_view::npos) return span_of(element);
    std::size_t const name_end = text_.find_first_of("= \t\r\n", name);
    std::size_t const begin = text_.find_first_of("\"'", name_end) + 1;
    std::size_t const end = text_.find(text_[begin - 1], begin);
    if (text_.substr(name, name_end - name) == attribute) return {file_, narrow(begin), narrow(end)};
    at = end + 1;
  }
}

std::vector<xml_node> Reader::inside(xml_node element, std::initializer_list<std::string_view> known) {
  std::vector<xml_node> result;
  for (xml_node const child : element.children()) {
    if (child.type() != pugi::node_element) continue;
    if (std::find(known.begin(), known.end(), child.name()) != known.end()) {
      result.push_back(child);
      continue;
    }
    std::string names;
    for (std::string_view const name : known) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
    report(Code::unknown_element, span_of(child), fmt::format("`{}` has no place in `{}`", child.name(), element.name()),
           {known.size() == 0 ? "there are no elements in it" : fmt::format("what there may be in it: {}", names)});
  }
  return result;
}

xml_node Reader::required_child(xml_node element, char const* name) {
  xml_node const child = element.child(name);
  if (child.empty()) report(Code::missing_part, span_of(element), fmt::format("the element `{}` has no element `{}`", element.name(), name));
  return child;
}

bool Reader::has(xml_node element, char const* name) {
  if (!element.attribute(name).empty()) return true;
  report(Code::missing_part, span_of(element), fmt::format("the element `{}` has no attribute `{}`", element.name(), name));
  return false;
}

Name Reader::attribute(xml_node element, char const* name) {
  if (!has(element, name)) return {};
  Name result{element.attribute(name).value(), span_of(element, name)};
  make_text(result.text);
  return result;
}

int Reader::number(xml_node element, char const* name, int least, int greatest) {
  if (!has(element, name)) return least;
  std::string_view const text = trimmed(element.attribute(name).value());
  auto const value = to_int(text);
  if (value && *value >= least && *value <= greatest) return *value;
  report(Code::bad_attribute, span_of(element, name), fmt::format("`{}` is `{}`, not a number from {} to {}", name, text, least, greatest));
  return least;
}

Orbit Reader::orbit(xml_node element, bool may_remove) {
  Orbit result;
  if (!has(element, "orbit")) return result;
  std::string_view rest = trimmed(element.attribute("orbit").value());
  while (!rest.empty()) {
    std::size_t const comma = std::min(rest.find(','), rest.size());
    auto const dimension = to_int(trimmed(rest.substr(0, comma)));
    if (!dimension || *dimension > highest_dimension || *dimension < (may_remove ? removed : 0)) {
      report(Code::bad_attribute, span_of(element, "orbit"),
             fmt::format("`orbit` has `{}`, which is not a dimension from 0 to {}", trimmed(rest.substr(0, comma)), highest_dimension),
             {may_remove ? "an orbit is a list of dimensions, and -1 for arcs that are removed: `0,-1,3`" : "an orbit is a list of dimensions: `1,2,3`"});
      return result;
    }
    result.push_back(*dimension);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return result;
}

Snippet Reader::code(xml_node element) {
  inside(element, {});
  Snippet result{.text = {}, .file = file_, .offsets = {}};
  std::size_t end = 0;
  for (xml_node const child : element.children()) {
    if (child.type() != pugi::node_pcdata && child.type() != pugi::node_cdata) continue;
    std::string_view const text = child.value();
    result.text += text;
    std::size_t at = static_cast<std::size_t>(child.offset_debug());
    for (std::size_t done = 0; done < text.size();) {
      auto const [in_file, in_text] = child.type() == pugi::node_cdata ? std::pair<std::size_t, std::size_t>{1, 1} : step(text_.substr(at));
      result.offsets.insert(result.offsets.end(), in_text, narrow(at));
      at += in_file;
      done += in_text;
    }
    end = at;
  }
  make_text(result.text);
  if (!result.text.empty()) result.offsets.push_back(narrow(end));
  return result;
}

// ---- The elements ----

Embedding Reader::read_embedding(xml_node element) {
  inside(element, {"comment", "defaultCode"});
  return {.name = attribute(element, "name"),
          .type = attribute(element, "type"),
          .orbit = orbit(element, false),
          .comment = code(element.child("comment")),
          .default_code = code(element.child("defaultCode"))};
}

Node Reader::read_node(xml_node element) {
  Node node{.name = attribute(element, "name"), .orbit = orbit(element, true), .multiplicity = {}, .clauses = {}, .precondition = {}};
  Name const kind = attribute(element, "kind");
  node.hook = kind.text == "HOOK";
  if (!node.hook && kind.text != "SIMPLE" && !kind.text.empty())
    report(Code::bad_attribute, kind.span, fmt::format("`kind` is `{}`, not `HOOK` or `SIMPLE`", kind.text));
  if (!element.attribute("multiplicity").empty()) node.multiplicity = attribute(element, "multiplicity");
  for (xml_node const child : inside(element, {"expr", "pre"})) {
    if (std::string_view(child.name()) == "pre") {
      node.precondition = code(child);
    } else {
      node.clauses.push_back({attribute(child, "ebd"), code(child)});
    }
  }
  return node;
}

Arc Reader::read_arc(xml_node element, Side const& side, std::string const& rule) {
  inside(element, {});
  auto const end = [&](char const* name) {
    Name const node = attribute(element, name);
    bool const known = std::any_of(side.nodes.begin(), side.nodes.end(), [&](Node const& other) { return other.name.text == node.text; });
    if (!known && !element.attribute(name).empty()) {  // a missing one has been reported
      std::string nodes;
      for (Node const& other : side.nodes) nodes += fmt::format("{}`{}`", nodes.empty() ? "" : ", ", other.name.text);
      report(Code::unknown_arc_end, node.span, fmt::format("an arc of the rule `{}` ends at `{}`, which is no node of that side", rule, node.text),
             {nodes.empty() ? "that side has no nodes" : fmt::format("its nodes: {}", nodes)});
    }
    return node.text;
  };
  bool const loop = std::string_view(element.name()) == "arcloop";
  Arc arc{.dimension = number(element, "dim", 0, highest_dimension), .a = {}, .b = {}, .span = span_of(element)};
  arc.a = end(loop ? "node" : "a");
  arc.b = loop ? arc.a : end("b");
  return arc;
}

Side Reader::read_side(xml_node element, std::string const& rule) {
  Side side;
  inside(element, {"nodes", "arcs"});
  for (xml_node const node : inside(element.child("nodes"), {"node"})) side.nodes.push_back(read_node(node));
  for (xml_node const arc : inside(element.child("arcs"), {"arc", "arcloop"})) side.arcs.push_back(read_arc(arc, side, rule));
  return side;
}

std::vector<Parameter> Reader::read_parameters(xml_node element) {
  std::vector<std::pair<int, Parameter>> found;
  for (xml_node const child : inside(element, {"paramebd"})) {
    int const order = child.attribute("order").empty() ? 0 : number(child, "order", 0, 1 << 20);
    found.push_back({order, {.name = attribute(child, "name"), .type = attribute(child, "type"), .default_code = code(child)}});
  }
  std::stable_sort(found.begin(), found.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
  std::vector<Parameter> result;
  for (auto& [order, parameter] : found) result.push_back(std::move(parameter));
  return result;
}

std::vector<std::string> Reader::read_hooks(xml_node element) {
  std::vector<std::pair<int, std::string>> found;
  for (xml_node const child : inside(element, {"paramtopo"})) {
    inside(child, {});
    int const order = child.attribute("order").empty() ? 0 : number(child, "order", 0, 1 << 20);
    found.push_back({order, attribute(child, "name").text});
  }
  std::stable_sort(found.begin(), found.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
  std::vector<std::string> result;
  for (auto& [order, name] : found) result.push_back(std::move(name));
  return result;
}

Rule Reader::read_rule(xml_node element) {
  inside(element, {"header", "precondition", "comment", "left", "right", "preprocess", "midprocess", "postprocess", "paramsebd", "paramstopo"});
  Rule rule{.name = attribute(element, "name"),
            .comment = code(element.child("comment")),
            .header = code(element.child("header")),
            .precondition = code(element.child("precondition")),
            .preprocess = code(element.child("preprocess")),
            .midprocess = code(element.child("midprocess")),
            .postprocess = code(element.child("postprocess")),
            .left = {},
            .right = {},
            .parameters = read_parameters(element.child("paramsebd")),
            .hooks = read_hooks(element.child("paramstopo"))};
  rule.left = read_side(required_child(element, "left"), rule.name.text);
  rule.right = read_side(required_child(element, "right"), rule.name.text);
  return rule;
}

Script Reader::read_script(xml_node element) { return {attribute(element, "name"), code(element.child("content"))}; }

void Reader::read_modeler(xml_node element, Modeler& modeler) {
  modeler.name = attribute(element, "name");
  modeler.dimension = number(element, "dimension", 0, highest_dimension);
  for (xml_node const part : inside(element, {"comment", "header", "generationType", "embeddings", "rules", "inferrules"})) {
    std::string_view const name = part.name();
    if (name == "comment") modeler.comment = code(part);
    if (name == "header") modeler.header = code(part);
    if (name == "embeddings") {
      for (xml_node const child : inside(part, {"embedding"})) modeler.embeddings.push_back(read_embedding(child));
    }
    if (name == "rules" || name == "inferrules") {
      for (xml_node const child : inside(part, {"rule", "script"})) {
        if (std::string_view(child.name()) == "rule") modeler.rules.push_back(read_rule(child));
        else modeler.scripts.push_back(read_script(child));
      }
    }
  }
}

std::optional<Modeler> Reader::run() {
  if (text_.size() > file_limit) {
    report(Code::file_too_large, {file_, 0, 0}, fmt::format("the file has {} bytes; modelers of more than {} MiB are not read", text_.size(), file_limit >> 20U));
    return std::nullopt;
  }
  if (auto const fault = syntax::find_text_fault(text_)) {
    auto const at = narrow(fault->offset);
    report(Code::not_utf8, {file_, at, at + 1},
           fmt::format("{} 0x{:02X}", fault->is_control ? "the file is not text: it has the control character" : "the file is not UTF-8: it has the byte",
                       static_cast<unsigned char>(text_[at])));
    return std::nullopt;
  }
  std::size_t const errors = diagnostics_.error_count();
  pugi::xml_document document;
  // Line ends stay as they are, so that places in the text are those in the file.
  unsigned const options = pugi::parse_cdata | pugi::parse_escapes;
  auto const parsed = document.load_buffer(text_.data(), text_.size(), options, pugi::encoding_utf8);
  if (!parsed) {
    auto const at = narrow(std::min(static_cast<std::size_t>(parsed.offset), text_.size()));
    std::string reason = parsed.description();
    if (!reason.empty()) reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
    report(Code::malformed_xml, {file_, at, at}, fmt::format("this is no XML: {}", reason));
    return std::nullopt;
  }
  xml_node const root = document.document_element();
  if (std::string_view(root.name()) != "jerboamodelereditor") {
    report(Code::unknown_element, span_of(root), fmt::format("the file holds `{}`, not a modeler of Jerboa: `jerboamodelereditor`", root.name()));
    return std::nullopt;
  }
  Modeler modeler;
  inside(root, {"openRules", "modeler"});
  if (xml_node const element = required_child(root, "modeler"); !element.empty()) read_modeler(element, modeler);
  if (diagnostics_.error_count() != errors) return std::nullopt;
  return modeler;
}

}  // namespace

std::optional<Modeler> read(source::Sources const& sources, source::FileId file, source::Diagnostics& diagnostics) {
  return Reader(sources, file, diagnostics).run();
}

}  // namespace jrule::jerboa

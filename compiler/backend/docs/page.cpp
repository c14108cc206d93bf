#include "compiler/backend/docs/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "compiler/analysis/effects_wording.h"
#include "compiler/analysis/independence.h"
#include "compiler/backend/docs/demonstration.h"
#include "compiler/backend/docs/prose.h"
#include "compiler/backend/draw/draw.h"
#include "compiler/backend/draw/style.h"

namespace jrule::docs {

namespace {

using draw::escape;
using Kind = Section::Kind;

constexpr char const* style = R"(
body { font: 16px/1.5 system-ui, sans-serif; color: #212121; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
code, pre { font-family: ui-monospace, Menlo, Consolas, 'DejaVu Sans Mono', monospace; font-size: 0.9em; }
pre { background: #f6f6f4; padding: 0.8rem 1rem; border-radius: 6px; overflow-x: auto; line-height: 1.4; }
section { border-top: 1px solid #ddd; margin-top: 2.5rem; }
h2 { font-size: 1.25rem; margin-bottom: 0.3rem; } h2 small { color: #757575; font-weight: normal; font-size: 0.8em; }
table { border-collapse: collapse; margin: 0.8rem 0; } th { text-align: left; font-weight: 600; }
td, th { padding: 0.15rem 1.2rem 0.15rem 0; vertical-align: top; } td > p { margin: 0; }
figure { margin: 1rem 0; overflow-x: auto; } figcaption { color: #616161; font-size: 0.9em; }
figure svg { max-width: 100%; height: auto; } .steps { display: flex; align-items: center; gap: 1rem; flex-wrap: wrap; }
a { color: #1565c0; text-decoration: none; } a:hover { text-decoration: underline; }
)";

std::string document(std::string const& title, std::string const& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      escape(title), style, body);
}

char const* kind_name(Kind kind) {
  switch (kind) {
    case Kind::model: return "model";
    case Kind::modeler: return "modeler";
    case Kind::rule: return "rule";
    case Kind::family: return "family";
    case Kind::operation: return "operation";
    case Kind::extern_type: return "type of C++";
    case Kind::extern_function: return "function of C++";
  }
  return "";
}

std::string code(std::string const& text) { return text.empty() ? "" : fmt::format("<code>{}</code>", escape(text)); }

/// A table; columns that are empty in all rows are left out.
std::string table(std::vector<std::string> const& heads, std::vector<std::vector<std::string>> const& rows) {
  if (rows.empty()) return "";
  auto const used = [&](std::size_t c) { return std::any_of(rows.begin(), rows.end(), [&](auto const& row) { return !row[c].empty(); }); };
  std::string html = "<table>\n";
  if (std::any_of(heads.begin(), heads.end(), [](std::string const& head) { return !head.empty(); })) {
    html += "<tr>";
    for (std::size_t c = 0; c < heads.size(); ++c) {
      if (used(c)) html += fmt::format("<th>{}</th>", heads[c]);
    }
    html += "</tr>\n";
  }
  for (auto const& row : rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < heads.size(); ++c) {
      if (used(c)) html += fmt::format("<td>{}</td>", row[c]);
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string figure(std::string const& pictures, std::string const& caption) {
  return fmt::format("<figure>\n{}{}</figure>\n", pictures, caption.empty() ? "" : fmt::format("<figcaption>{}</figcaption>\n", caption));
}

class PageWriter {
 public:
  PageWriter(Module const& module, ir::Program const& program, std::vector<analysis::Verdict> const& verdicts, std::vector<Page> const& pages)
      : module_(module), program_(program), verdicts_(verdicts), pages_(pages) {
    for (Section const& s : module.sections) links_[s.name] = "#" + s.name;
  }

  std::string write() const {
    std::string html;
    if (pages_.size() > 1) html += "<p><a href=\"index.html\">All modules</a></p>\n";
    html += fmt::format("<h1>{}</h1>\n{}", escape(module_.name), prose(module_.doc, links_));
    html += imports() + contents() + legend();
    for (Section const& s : module_.sections) html += section(s);
    return document(module_.name, html);
  }

 private:
  std::string imports() const {
    std::vector<std::string> names;
    for (Module::Import const& import : module_.imports) {
      std::error_code error;
      auto const page = std::find_if(pages_.begin(), pages_.end(), [&](Page const& p) { return std::filesystem::equivalent(p.path, import.path, error); });
      names.push_back(page == pages_.end() ? code(import.name) : fmt::format("<a href=\"{}\">{}</a>", escape(page->file), code(import.name)));
    }
    return names.empty() ? "" : fmt::format("<p>Imports {}.</p>\n", fmt::join(names, ", "));
  }

  std::string contents() const {
    std::vector<std::vector<std::string>> rows;
    for (Section const& s : module_.sections) {
      rows.push_back({fmt::format("<a href=\"#{}\">{}</a>", escape(s.name), code(s.name)), kind_name(s.kind), inline_prose(first_sentence(s.doc), {})});
    }
    return table({"", "", ""}, rows);
  }

  /// How to read the pictures, if there are any.
  std::string legend() const {
    bool const any = std::any_of(module_.sections.begin(), module_.sections.end(), [](Section const& s) { return s.rule.has_value(); });
    if (!any) return "";
    return "<details>\n<summary>How to read the pictures</summary>\n<p>A rule is drawn as in the papers: its left side, then its right side. Each "
           "node stands for one copy of the pattern, which is found from the hook, the node with a double ring. Under its name a node says what "
           "becomes of the pattern's arcs in its copy, position by position of the hook's type: a dimension, or <code>_</code> if they go. Red nodes "
           "are deleted, green ones are added. 0-arcs are black, 1-arcs red and dashed, 2-arcs blue and double, 3-arcs green and dotted; "
           "<code>1[2,~1]</code> is a 1-arc that carries the word 2, then 1 backwards, read in the direction of the tip or from the small ring."
           "</p>\n</details>\n";
  }

  std::string section(Section const& s) const {
    std::string html = fmt::format("<section id=\"{}\">\n<h2><code>{}</code> <small>{}</small></h2>\n", escape(s.name), escape(s.signature),
                                   kind_name(s.kind));
    html += prose(s.doc, links_);
    if (s.rule) html += picture(s);
    html += demonstration(s) + parameters(s) + nodes(s) + embeddings(s);
    if (s.rule) html += proved(s);
    return html + fmt::format("<pre>{}</pre>\n</section>\n", escape(s.source));
  }

  std::string picture(Section const& s) const {
    std::string caption;
    if (s.kind == Kind::family) {
      Model const& model = s.rule->model();
      caption = fmt::format("{} on {}", code(s.rule->name), code(fmt::format("{}({})", model.name, model.dimension)));
    }
    return figure(draw::rule_svg(*s.rule), caption);
  }

  std::string demonstration(Section const& s) const {
    std::optional<Demonstration> const shown = s.operation ? demonstrate(program_, verdicts_, *s.operation)
                                               : s.rule    ? demonstrate(*s.rule, s.plan)
                                                           : std::nullopt;
    if (!shown) return "";
    std::string const arrow = shown->before.empty() ? "" : "<span>→</span>\n";
    return figure(fmt::format("<div class=\"steps\">\n{}{}{}</div>\n", shown->before, arrow, shown->after),
                  fmt::format("{} {}", code(shown->call), escape(shown->place)));
  }

  std::string parameters(Section const& s) const {
    std::vector<std::vector<std::string>> rows;
    for (Parameter const& p : s.parameters) {
      rows.push_back({code(p.name), code(p.type), code(p.default_value), escape(p.unit), inline_prose(p.doc, links_)});
    }
    return table({"Parameter", "Type", "Default", "Unit", ""}, rows);
  }

  std::string nodes(Section const& s) const {
    std::vector<std::vector<std::string>> hooks, others;
    for (Node const& n : s.nodes) (n.hook ? hooks : others).push_back({code(n.name), code(n.decoration), inline_prose(n.doc, links_)});
    return table({"Hook", "Orbit", ""}, hooks) + table({"Node", "", ""}, others);
  }

  std::string embeddings(Section const& s) const {
    std::vector<std::vector<std::string>> rows;
    for (Embedding const& e : s.embeddings) {
      rows.push_back({code(e.name), code(e.orbit), code(e.type), code(e.default_value), code(e.merge), inline_prose(e.doc, links_)});
    }
    return table({"Embedding", "Orbit", "Type", "Default", "Merged by", ""}, rows);
  }

  /// What the analysis says, as `jrule explain` tells it.
  std::string proved(Section const& s) const {
    analysis::EffectsWording const wording = analysis::describe(*s.rule, analysis::analyze_effects(*s.rule, s.plan));
    std::string html = fmt::format("<p><strong>Proved{}:</strong> {}{}.</p>\n",
                                   s.kind == Kind::family ? " of " + code(s.rule->name) : "", inline_prose(wording.where, {}),
                                   analysis::analyze_independence(*s.rule, s.plan).independent() ? "; may be applied everywhere at once" : "");
    std::vector<std::vector<std::string>> rows;
    for (analysis::EffectLine const& line : wording.lines) {
      rows.push_back({line.cells, line.effect, fmt::format("<code>{}</code>", escape(fmt::format("{}", fmt::join(line.nodes, ", ")))), escape(line.number)});
    }
    html += table({"Cells", "", "Copies of", "How many"}, rows);
    std::vector<std::string> counts;
    for (std::string const& count : wording.counts) counts.push_back(escape(count));
    return counts.empty() ? html : html + fmt::format("<p>{}</p>\n", fmt::join(counts, "<br/>\n"));
  }

  Module const& module_;
  ir::Program const& program_;
  std::vector<analysis::Verdict> const& verdicts_;
  std::vector<Page> const& pages_;
  Links links_;
};

}  // namespace

std::string page(Module const& module, ir::Program const& program, std::vector<analysis::Verdict> const& verdicts, std::vector<Page> const& pages) {
  return PageWriter(module, program, verdicts, pages).write();
}

std::string index(std::vector<Module> const& modules, std::vector<Page> const& pages) {
  std::string html = "<h1>Modules</h1>\n";
  for (std::size_t i = 0; i < modules.size(); ++i) {
    std::string const file = escape(pages[i].file);
    html += fmt::format("<section>\n<h2><a href=\"{}\">{}</a></h2>\n<p>{}</p>\n", file, escape(modules[i].name), inline_prose(first_sentence(modules[i].doc), {}));
    std::vector<std::string> names;
    for (Section const& s : modules[i].sections) names.push_back(fmt::format("<a href=\"{}#{}\">{}</a>", file, escape(s.name), code(s.name)));
    html += fmt::format("<p>{}</p>\n</section>\n", fmt::join(names, " "));
  }
  return document("Modules", html);
}

}  // namespace jrule::docs

// `jrule docs FILE… -o DIR`: pages on what is accepted as it is. A file with errors has none, and then nothing is written.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/backend/docs/page.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/output.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

namespace {

namespace fs = std::filesystem;

/// Their pages' names; none, printed, if two files would have one page.
std::optional<std::vector<docs::Page>> name_pages(std::vector<std::string> const& files) {
  std::vector<docs::Page> pages;
  for (std::string const& file : files) {
    std::string const name = fs::path(file).stem().string() + ".html";
    auto const same = std::find_if(pages.begin(), pages.end(), [&](docs::Page const& page) { return page.file == name; });
    if (same != pages.end()) {
      print_error(fmt::format("`{}` and `{}` would have one page, `{}`: write them to two folders", same->path, file, name));
      return {};
    }
    if (files.size() > 1 && name == "index.html") {
      print_error(fmt::format("the page of `{}` would be the index: write it to a folder of its own", file));
      return {};
    }
    pages.push_back({file, name});
  }
  return pages;
}

/// What `check` says to notes on families is said of them on the page.
bool is_worth_telling(source::Diagnostics const& diagnostics) {
  return std::any_of(diagnostics.all().begin(), diagnostics.all().end(),
                     [](source::Diagnostic const& d) { return source::severity(d) != source::Severity::note; });
}

}  // namespace

int docs(DocsOptions const& options) {
  auto const pages = name_pages(options.files);
  if (!pages) return exit_usage;
  if (options.files.size() > 1 && options.directory.empty()) {
    print_error("the pages of several files need a folder to be written to: `-o DIR`");
    return exit_usage;
  }
  std::vector<std::unique_ptr<Compilation>> compilations;
  int worst = exit_ok;
  for (std::string const& file : options.files) {
    compilations.push_back(compile(file, options.common));
    Compilation const& c = *compilations.back();
    if (is_worth_telling(c.diagnostics)) print(c.sources, c.diagnostics, options.common);
    worst = std::max(worst, status(c.diagnostics));
  }
  if (worst != exit_ok) return worst;

  std::vector<docs::Module> modules;
  std::vector<Output> outputs;
  std::vector<std::string> sources;
  for (std::size_t i = 0; i < compilations.size(); ++i) {
    Compilation const& c = *compilations[i];
    modules.push_back(docs::describe(c.sources, c.modules, c.program, c.verdicts));
    outputs.push_back({(*pages)[i].file, docs::page(modules.back(), c.program, c.verdicts, *pages)});
    sources.insert(sources.end(), c.modules.paths.begin(), c.modules.paths.end());
  }
  if (modules.size() > 1) outputs.push_back({"index.html", docs::index(modules, *pages)});
  if (options.directory.empty()) {
    fmt::print("{}", outputs.front().text);
    return exit_ok;
  }
  EmitOptions where;
  where.directory = options.directory;
  return write_outputs(where, sources, outputs);
}

}  // namespace jrule::driver

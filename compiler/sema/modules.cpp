#include "compiler/sema/modules.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include "compiler/source/read.h"
#include "compiler/syntax/parse.h"

namespace jrule::sema {

namespace fs = std::filesystem;
using source::Code;

namespace {

struct Loader {
  SearchPath const& search;
  source::Sources& sources;
  source::Diagnostics& diagnostics;
  Modules result;
  std::map<std::string, std::optional<std::size_t>> modules;  // by canonical path; none while its imports are being read

  static std::string key(std::string const& path) {
    std::error_code error;
    fs::path const canonical = fs::weakly_canonical(path, error);
    return error ? path : canonical.string();
  }

  std::optional<std::string> find(ast::Import const& import, std::string const& importer) const {
    fs::path relative;
    for (ast::Name const& part : import.path) relative /= part.text;
    relative += ".jrule";
    std::vector<fs::path> candidates;
    if (import.path.front().text == "std") {
      if (!search.stdlib.empty()) candidates.push_back(fs::path(search.stdlib) / relative);
    } else {
      candidates.push_back(fs::path(importer).parent_path() / relative);
      for (std::string const& folder : search.folders) candidates.push_back(fs::path(folder) / relative);
    }
    for (fs::path const& candidate : candidates) {
      std::error_code error;
      if (fs::is_regular_file(candidate, error)) return candidate.string();
    }
    return {};
  }

  void load(std::string const& path, std::string name, source::Span at) {
    auto text = source::read_file(path);
    if (!text) {
      diagnostics.add({.code = Code::cannot_read_file, .span = at, .message = fmt::format("cannot read `{}`: {}", path, text.error())});
      return;
    }
    std::string const id = key(path);
    modules[id] = std::nullopt;
    result.paths.push_back(path);
    source::FileId const file = sources.add(path, std::move(*text));
    ast::File ast = syntax::parse(sources, file, diagnostics);
    std::vector<Module::Import> imports;
    for (ast::Item const& item : ast.items) {
      auto const* import = std::get_if<ast::Import>(&item);
      if (!import) continue;
      if (auto const module = load_import(*import, path)) imports.push_back({*module, import->span});
    }
    modules[id] = result.all.size();
    result.all.push_back({std::move(name), std::move(ast), std::move(imports)});
  }

  // The module's index, if it could be read.
  std::optional<std::size_t> load_import(ast::Import const& import, std::string const& importer) {
    std::string name;
    for (ast::Name const& part : import.path) name += (name.empty() ? "" : ".") + part.text;
    std::optional<std::string> const path = find(import, importer);
    if (!path) {
      diagnostics.add({.code = Code::import_not_found,
                       .span = import.span,
                       .message = fmt::format("module `{}` is not found", name),
                       .notes = {import.path.front().text == "std"
                                     ? std::string("`std` modules come with the compiler")
                                     : std::string("it is looked up beside the importing file, then along `-I`")}});
      return {};
    }
    std::string const id = key(*path);
    if (!modules.contains(id)) {
      load(*path, name, import.span);
    } else if (!modules[id]) {
      diagnostics.add({.code = Code::import_cycle,
                       .span = import.span,
                       .message = fmt::format("importing `{}` here closes a cycle of imports", name)});
    }
    auto const known = modules.find(id);
    return known == modules.end() ? std::nullopt : known->second;
  }
};

}  // namespace

Modules load(std::string const& path, SearchPath const& search, source::Sources& sources, source::Diagnostics& diagnostics) {
  Loader loader{search, sources, diagnostics, {}, {}};
  loader.load(path, fs::path(path).stem().string(), {});
  return std::move(loader.result);
}

}  // namespace jrule::sema

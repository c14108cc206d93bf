// Pages of documentation: what a module offers, with pictures of it.
//
// They are HTML with the pictures in it as SVG. One file is then all that there is: it can be opened, moved, attached and served as it
// is, without a program that turns it into a page; Markdown would need the pictures beside it, since renderers leave inline
// SVG out. It is XML too, so that other programs can read it.
#pragma once

#include <string>
#include <vector>

#include "compiler/backend/docs/module.h"

namespace jrule::docs {

/// The pages that are made together: paths of source files and the names of their pages, "surface.html".
struct Page {
  std::string path, file;
};

/// The page of one module: each item with its documentation, parameters, hooks and text; of rules what is proved of them and a picture
/// of both sides; and what they do to a small surface, where that can be shown. Imported modules among `pages` are linked, and so is
/// the index if there are several. Equal input, equal bytes.
std::string page(Module const& module, ir::Program const& program, std::vector<analysis::Verdict> const& verdicts, std::vector<Page> const& pages);

/// "index.html": all modules with their items; one page for each.
std::string index(std::vector<Module> const& modules, std::vector<Page> const& pages);

}  // namespace jrule::docs

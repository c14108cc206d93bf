// Names: the nearest spelling, for "did you mean".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

/// The candidate at the least edit distance, if that is at most 2 and less than the name's length.
std::optional<std::string> nearest(std::string const& name, std::vector<std::string> const& candidates);

/// Reports with that message that the name is none of the known ones, with a fix-it if one is near, else with all in a note.
void report_not_found(source::Diagnostics& diagnostics, source::Code code, ast::Name const& name, std::string message,
                      std::vector<std::string> const& known);

/// Reports an unknown name, with a fix-it if a known one is near and with the known ones in a note otherwise.
void report_unknown(source::Diagnostics& diagnostics, source::Code code, ast::Name const& name, std::string const& what,
                    std::vector<std::string> const& known);

}  // namespace jrule::sema

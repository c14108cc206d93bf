// The words for a syntax error: what was expected, what was found.
#pragma once

#include <string>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/item_parser.h"

namespace jrule::syntax {

/// `following` says what stands after the item: "the end of the file", "`rule`".
source::Diagnostic describe(ItemParser const& parser, std::string const& following);

}  // namespace jrule::syntax

// Modeler -> text of a .jrule file.
#pragma once

#include <string>

#include "compiler/jerboa/modeler.h"
#include "compiler/source/diagnostic.h"

namespace jrule::jerboa {

/// A module of the modeler with its embeddings and rules, not yet laid out; whether the rules are consistent is not asked.
/// It follows the grammar, unless the modeler exceeds the limits of the language (an item of 1 MiB). `origin` names the file that it is from. Code that is not translated (J0611) and scripts (J0612) become comments; what else
/// is left out or changed is reported too (J0613 … J0615). Cost: linear in the modeler, about that of parsing the text.
std::string write(Modeler const& modeler, std::string const& origin, source::Diagnostics& diagnostics);

}  // namespace jrule::jerboa

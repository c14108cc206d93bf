// XML -> Modeler.
#pragma once

#include <optional>

#include "compiler/jerboa/modeler.h"
#include "compiler/source/diagnostic.h"

namespace jrule::jerboa {

/// The modeler that the file holds; nothing if there are errors, which are reported (J0002, J0006, J0601 … J0605), all those of a
/// well-formed file at once. What only the drawing of a rule needs is not read. Cost: linear in the text.
std::optional<Modeler> read(source::Sources const& sources, source::FileId file, source::Diagnostics& diagnostics);

}  // namespace jrule::jerboa

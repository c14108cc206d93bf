// A map in a few lines.
#pragma once

#include <string>

#include "jrule/map.h"

namespace jrule::driver {

/// For people: "11 024 vertices, 22 044 edges, 11 022 faces, 88 176 darts, valid", and a line on the whole.
std::string summary_text(Summary const& summary);
/// One object: model dimension darts cells components euler orientable boundary_darts valid.
std::string summary_json(Summary const& summary);

}  // namespace jrule::driver

// What a host holds as `jrule_map`.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "jrule/plugin_support.h"
#include "outcome.h"

struct jrule_map {
  jrule::plugin::Table const* table;  ///< of its plugin; first, so that a map of any plugin can be asked
  std::uint32_t modeler;
  std::unique_ptr<jrule::plugin::AnyMap> content;
};

namespace jrule::plugin {

/// Refuses null pointers and maps of other plugins.
Outcome check_map(Table const& table, jrule_map const* map);
/// Refuses a null pointer; `what` is "the pointer to the result".
Outcome check_pointer(void const* pointer, char const* what);

}  // namespace jrule::plugin

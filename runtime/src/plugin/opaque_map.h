// What a host holds as `jrule_map`.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "jrule/plugin_support.h"
#include "outcome.h"

struct jrule_map {
  void const* owner;  ///< first, so that a map of any plugin can be asked
  jrule::plugin::Table const* table;
  std::uint32_t modeler;
  std::unique_ptr<jrule::plugin::AnyMap> content;
};

namespace jrule::plugin {

/// What maps of this library have as their owner: each library has its own.
void const* this_library() noexcept;

/// Refuses null pointers and maps of other libraries.
Outcome check_map(jrule_map const* map);
/// Refuses a null pointer; `what` is "the pointer to the result".
Outcome check_pointer(void const* pointer, char const* what);

}  // namespace jrule::plugin

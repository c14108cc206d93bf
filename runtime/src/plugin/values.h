// Values of the language as C values.
#pragma once

#include <string>

#include "jrule/plugin.h"
#include "jrule/value.h"
#include "outcome.h"

namespace jrule::plugin {

jrule_value to_c(Value const& value) noexcept;

/// Refuses one of another type, and numbers that are not finite. `what` is "the parameter `apex`".
tl::expected<Value, Failure> from_c(jrule_value const& value, Type type, std::string const& what);

}  // namespace jrule::plugin

// `extern type` and `extern fn`: C++ types and functions that rules may use (language reference, section 6).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/modules.h"

namespace jrule::sema {

/// Those of all loaded modules by name, as models and rules are found: of several modules, the last one that declares
/// the name counts. Null where the declaration is wrong, which is reported.
struct Externs {
  std::map<std::string, ir::ExternTypePtr> types;
  std::map<std::string, ir::ExternFunctionPtr> functions;

  std::vector<std::string> type_names() const;
  std::vector<std::string> function_names() const;
};

/// Reports names that the language has already (J0208), types that are not known (J0204), and headers and C++ names
/// that cannot be ones (J0230).
Externs collect_externs(Modules const& modules, source::Diagnostics& diagnostics);

/// The function of the arguments, none of which is null. Null, reported, if their number (J0242) or a type (J0240) is
/// not the declared one; an Int is taken where a Real is declared.
ir::ExprPtr call_extern(ir::ExternFunctionPtr function, source::Span name, std::vector<ir::ExprPtr> arguments,
                        source::Span span, source::Diagnostics& diagnostics);

}  // namespace jrule::sema

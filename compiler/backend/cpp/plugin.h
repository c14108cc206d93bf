// Modules -> the generated part of a plugin: the tables of what it offers, and the way from plain arguments to each
// rule.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/backend/cpp/emit.h"

namespace jrule::cpp {

struct PluginModule {
  ir::Program const& program;
  std::vector<Rule> rules;
  source::Sources const& sources;
  source::Diagnostics& diagnostics;
};

/// "<name>_plugin.cpp", a source beside those that emit() writes with the same options for each module, whose headers
/// it includes. Linked with them and jrule::runtime as a shared library it is the plugin that
/// runtime/include/jrule/plugin.h describes. Equal inputs give equal bytes. A rule with a parameter of an extern type
/// is listed as one that cannot be called. A name of a rule or a modeler that C++ cannot use is reported to its module (J0901), and then
/// nothing is returned.
std::optional<GeneratedFile> emit_plugin(std::string const& name, std::vector<PluginModule> const& modules,
                                         Options const& options);

}  // namespace jrule::cpp

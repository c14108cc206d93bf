// Files that `jrule emit` writes.
#pragma once

#include <string>
#include <vector>

#include "compiler/driver/commands.h"

namespace jrule::driver {

struct Output {
  std::string name;
  std::string text;
};

/// Writes them to the folder that the options name, and last the depfile, if one is asked for: that they come from
/// `sources`, which are never overwritten. The exit status; what goes wrong is printed.
int write_outputs(EmitOptions const& options, std::vector<std::string> const& sources,
                  std::vector<Output> const& outputs);

}  // namespace jrule::driver

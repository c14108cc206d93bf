#pragma once

namespace jrule::driver {

/// Parses the command line and runs the subcommand; returns the exit status.
int run(int argc, char const* const* argv);

}  // namespace jrule::driver

// How messages reach the user.
#pragma once

#include <string>

#include "compiler/driver/commands.h"
#include "compiler/source/diagnostic.h"
#include "jrule/result.h"

namespace jrule::driver {

/// Prints the diagnostics, sorted: for people to standard error, as json to standard output.
void print(source::Sources const& sources, source::Diagnostics const& diagnostics, Common const& common);
/// The exit status that they call for: files that could not be read are 2, errors 1.
int status(source::Diagnostics const& diagnostics);

/// "jrule: error: …" on standard error.
void print_error(std::string const& text);
void print_error(Error const& error);

}  // namespace jrule::driver

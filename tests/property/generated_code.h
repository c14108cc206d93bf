// Rules as generated C++, compiled and loaded into this program.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/property/application.h"

namespace jrule::property {

struct AcceptedRule {
  ir::RuleScheme scheme;
  analysis::Plan plan;
};

struct GeneratedRule {
  Application apply;
  /// The function that applies it to each orbit; none unless it has one hook.
  std::function<Result<void>(Map& map, Threads threads)> everywhere;
};

/// Prints the rules by the C++ backend, compiles them as this program was compiled and loads them. No two rules have
/// the same name, and all names are fit for C++. `name` is an identifier that no other call of this program uses: also
/// that of the folder, below the build's, which keeps the code and what is made of it. The result stays valid. Throws
/// std::runtime_error with the compiler's messages if the code does not compile without warnings.
std::vector<GeneratedRule> compile_rules(std::vector<AcceptedRule> const& rules, std::string const& name);

/// An empty folder of that name, below the build's.
std::filesystem::path make_folder(std::string const& name);
/// Compiles a file there, as this program was compiled, loads it for good, and gives what the symbol means. Throws as
/// compile_rules().
void* load(std::filesystem::path const& folder, std::string const& file, char const* symbol);

}  // namespace jrule::property

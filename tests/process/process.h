// Running programs as a user does, and the files around them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jrule::tests {

struct Outcome {
  int exit_status = 0;  ///< as a shell gives it: 128 + N after signal N
  std::string output;   ///< standard output and standard error, as they came
};

/// Runs a program with these arguments in a folder, so that paths in its output are relative to that, without input.
Outcome run(std::filesystem::path const& folder, std::vector<std::string> const& command);

/// Throws if it cannot be read or written.
std::string read(std::filesystem::path const& path);
void write(std::filesystem::path const& path, std::string const& text);

}  // namespace jrule::tests

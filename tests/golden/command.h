// Running the compiler as a user does, and the files around it.
#pragma once

#include <filesystem>
#include <string>

namespace jrule::golden {

struct Outcome {
  int exit_status = 0;  ///< as a shell gives it: 128 + N after signal N
  std::string output;   ///< standard output and standard error, as they came
};

/// `jrule check FILE` in a folder, so that paths in its output are relative to that.
Outcome check(std::filesystem::path const& folder, std::string const& file);

/// Throws if it cannot be read or written.
std::string read(std::filesystem::path const& path);
void write(std::filesystem::path const& path, std::string const& text);

}  // namespace jrule::golden

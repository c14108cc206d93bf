// A whole file as bytes.
#pragma once

#include <string>

#include <tl/expected.hpp>

namespace jrule::source {

/// The bytes of the file; else why it cannot be read, in the system's words: "No such file or directory".
tl::expected<std::string, std::string> read_file(std::string const& path);

}  // namespace jrule::source

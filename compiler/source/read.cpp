#include "compiler/source/read.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace jrule::source {

tl::expected<std::string, std::string> read_file(std::string const& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return tl::unexpected(std::string("is a folder"));
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) return tl::unexpected(std::generic_category().message(errno));
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) return tl::unexpected(std::string("reading failed"));
  return bytes;
}

}  // namespace jrule::source

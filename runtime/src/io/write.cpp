#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>

#include "formats.h"
#include "jrule/io.h"

namespace jrule {
namespace {

Result<std::string> print(Map const& map, std::string const& path) {
  std::string const suffix = io::suffix_of(path);
  if (suffix == ".jmap") return io::print_checked_jmap(map);
  io::SurfaceFormat const* const format = io::find_format(suffix);
  if (format == nullptr) return io::unknown_format(path);
  auto const surface = io::to_surface(map);
  if (!surface) return tl::unexpected(surface.error());
  return format->print(*surface);
}

}  // namespace

Result<void> write_whole_file(std::string const& path, std::string const& bytes) {
  auto const error = [&](std::string const& reason) {
    return fail(Error::Kind::io, "cannot write the file: " + reason, path);
  };
  // Beside the target, for only within one file system can a file be renamed. Mode x: never a file that exists.
  std::string temporary;
  std::FILE* out = nullptr;
  for (int attempt = 0; out == nullptr; ++attempt) {
    temporary = path + ".part" + std::to_string(attempt);
    errno = 0;
    out = std::fopen(temporary.c_str(), "wbx");
    if (out == nullptr && (errno != EEXIST || attempt == 99)) return error(std::generic_category().message(errno));
  }
  errno = 0;
  bool const written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
  bool const closed = std::fclose(out) == 0;  // may find the disk full too
  std::error_code code(errno, std::generic_category());
  if (written && closed) {
    std::filesystem::rename(temporary, path, code);
    if (!code) return {};
  }
  std::string const reason = code.message();
  std::filesystem::remove(temporary, code);
  return error(reason);
}

Result<void> write_map(Map const& map, std::string const& path) {
  try {
    auto bytes = print(map, path);
    if (!bytes) {
      bytes.error().file = path;
      return tl::unexpected(bytes.error());
    }
    return write_whole_file(path, *bytes);
  } catch (std::bad_alloc const&) {
    return fail(Error::Kind::no_memory, "the file's text does not fit into memory", path);
  }
}

}  // namespace jrule

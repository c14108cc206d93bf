#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

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

/// A file on its way: its content under another name, which goes with the object unless it has appeared under its own.
class Part {
 public:
  explicit Part(std::string path) : path_(std::move(path)) {}
  Part(Part&& other) noexcept : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}
  Part& operator=(Part&&) = delete;
  ~Part() {
    std::error_code code;
    if (!temporary_.empty()) std::filesystem::remove(temporary_, code);
  }

  Result<void> write(std::string const& bytes) {
    // Beside the target, for only within one file system can a file be renamed. Mode x: never a file that exists.
    std::FILE* out = nullptr;
    std::string name;
    for (int attempt = 0; out == nullptr; ++attempt) {
      name = path_ + ".part" + std::to_string(attempt);
      errno = 0;
      out = std::fopen(name.c_str(), "wbx");
      if (out == nullptr && (errno != EEXIST || attempt == 99)) return error(std::generic_category().message(errno));
    }
    temporary_ = name;
    errno = 0;
    bool const written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
    bool const closed = std::fclose(out) == 0;  // may find the disk full too
    if (!written || !closed) return error(std::generic_category().message(errno));
    // Found out before anything appears.
    std::error_code code;
    if (std::filesystem::is_directory(path_, code)) return error(std::generic_category().message(EISDIR));
    return {};
  }

  Result<void> appear() {
    std::error_code code;
    std::filesystem::rename(temporary_, path_, code);
    if (code) return error(code.message());
    temporary_.clear();
    return {};
  }

 private:
  Result<void> error(std::string const& reason) const { return fail(Error::Kind::io, "cannot write the file: " + reason, path_); }

  std::string path_, temporary_;
};

}  // namespace

Result<void> write_whole_files(std::span<FileText const> files) {
  std::vector<Part> parts;
  parts.reserve(files.size());
  for (FileText const& file : files) {
    parts.emplace_back(file.path);
    if (auto const written = parts.back().write(file.bytes); !written) return written;
  }
  for (Part& part : parts) {
    if (auto const appeared = part.appear(); !appeared) return appeared;
  }
  return {};
}

Result<void> write_whole_file(std::string const& path, std::string const& bytes) {
  Part part(path);
  if (auto const written = part.write(bytes); !written) return written;
  return part.appear();
}

Result<std::string> map_text(Map const& map, std::string const& path) {
  try {
    auto bytes = print(map, path);
    if (!bytes) bytes.error().file = path;
    return bytes;
  } catch (std::bad_alloc const&) {
    return fail(Error::Kind::no_memory, "the file's text does not fit into memory", path);
  }
}

Result<void> write_map(Map const& map, std::string const& path) {
  auto const text = map_text(map, path);
  if (!text) return tl::unexpected(text.error());
  return write_whole_file(path, *text);
}

}  // namespace jrule

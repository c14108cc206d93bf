#include "outcome.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

namespace jrule::plugin {

namespace {

// The longest beginning that fits, and that does not end within a character of UTF-8.
void copy_text(std::string_view text, std::span<char> room) noexcept {
  std::size_t length = std::min(text.size(), room.size() - 1);
  if (length < text.size()) {
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0U) == 0x80U) --length;
  }
  if (length > 0) std::memcpy(room.data(), text.data(), length);
  room[length] = '\0';
}

}  // namespace

std::int32_t code_of(Error::Kind kind) noexcept {
  switch (kind) {
    case Error::Kind::not_applicable: return JRULE_NOT_APPLICABLE;
    case Error::Kind::bad_input: return JRULE_BAD_INPUT;
    case Error::Kind::io: return JRULE_IO;
    case Error::Kind::no_memory: return JRULE_NO_MEMORY;
    case Error::Kind::limit: return JRULE_LIMIT;
    case Error::Kind::cancelled: return JRULE_CANCELLED;
  }
  return JRULE_BAD_INPUT;
}

tl::unexpected<Failure> failed(Error error) {
  std::int32_t const code = code_of(error.kind);
  return tl::unexpected(Failure{code, std::move(error)});
}

tl::unexpected<Failure> bad_argument(std::string message) {
  return tl::unexpected(Failure{JRULE_BAD_ARGUMENT, {Error::Kind::bad_input, std::move(message), {}, 0}});
}

tl::unexpected<Failure> cancelled(std::string_view rule) {
  return tl::unexpected(
      Failure{JRULE_CANCELLED,
              {Error::Kind::bad_input, '`' + std::string(rule) + "` was cancelled: the map is as it was", {}, 0}});
}

std::int32_t report(jrule_error* error, std::int32_t code, std::string_view message, std::string_view file,
                    std::size_t line) noexcept {
  if (error == nullptr) return code;
  error->code = code;
  error->line = static_cast<std::uint32_t>(std::min<std::size_t>(line, std::numeric_limits<std::uint32_t>::max()));
  copy_text(file, error->file);
  copy_text(message, error->message);
  return code;
}

}  // namespace jrule::plugin

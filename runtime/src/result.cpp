#include "jrule/result.h"

#include <utility>

namespace jrule {

std::string to_string(Error const& error) {
  std::string text = error.file;
  if (error.line != 0) {
    if (!text.empty()) text += ':';
    text += std::to_string(error.line);
  }
  if (!text.empty()) text += ": ";
  return text + error.message;
}

tl::unexpected<Error> fail(Error::Kind kind, std::string message, std::string file, std::size_t line) {
  return tl::unexpected<Error>(Error{kind, std::move(message), std::move(file), line});
}

}  // namespace jrule

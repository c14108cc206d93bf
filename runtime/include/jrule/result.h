// How the runtime reports: a value, or an error that says what is wrong and where. It never prints and never exits.
#pragma once

#include <cstddef>
#include <string>

#include <tl/expected.hpp>

namespace jrule {

struct Error {
  enum class Kind {
    not_applicable,  ///< a rule's left side does not match there, or an operation fails; the map is as it was
    bad_input,       ///< a file's content, an argument
    io,              ///< a file cannot be read or written
    no_memory,       ///< more darts than the index type or the memory holds; the map is as it was
    limit,           ///< operations call each other too deeply; the map is as it was
    cancelled,       ///< an operation was cancelled by its caller; the map is as it was
  };
  Kind kind = Kind::bad_input;
  std::string message;   ///< lower case, no full stop
  std::string file;      ///< the file it is about; empty if none
  std::size_t line = 0;  ///< 1-based line in `file`; 0 if none
};

/// "file:line: message", without the parts that are empty.
std::string to_string(Error const& error);

template <class T>
using Result = tl::expected<T, Error>;

/// `return fail(Error::Kind::io, …)` from a function that returns a Result.
tl::unexpected<Error> fail(Error::Kind kind, std::string message, std::string file = {}, std::size_t line = 0);

}  // namespace jrule

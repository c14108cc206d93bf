// How the functions of a plugin fail: by a value inside, by a code and a text outside. Nothing is thrown across.
#pragma once

#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "jrule/plugin.h"
#include "jrule/result.h"

namespace jrule::plugin {

struct Failure {
  std::int32_t code;
  Error error;
};
using Outcome = tl::expected<void, Failure>;

std::int32_t code_of(Error::Kind kind) noexcept;
tl::unexpected<Failure> failed(Error error);
tl::unexpected<Failure> bad_argument(std::string message);
tl::unexpected<Failure> cancelled(std::string_view rule);

/// Tells the caller, if it wants to be told, and gives the code back. Allocates nothing.
std::int32_t report(jrule_error* error, std::int32_t code, std::string_view message, std::string_view file = {},
                    std::size_t line = 0) noexcept;

/// Runs it, whatever it throws.
template <class Body>
std::int32_t guarded(jrule_error* error, Body body) noexcept {
  try {
    Outcome const outcome = body();
    if (outcome) return report(error, JRULE_OK, {});
    Failure const& failure = outcome.error();
    return report(error, failure.code, failure.error.message, failure.error.file, failure.error.line);
  } catch (std::bad_alloc const&) {
    return report(error, JRULE_NO_MEMORY, "there is not enough memory");
  } catch (std::length_error const&) {
    return report(error, JRULE_NO_MEMORY, "there is not enough memory");
  } catch (std::exception const& thrown) {
    return report(error, JRULE_THROWN, thrown.what());
  } catch (...) {
    return report(error, JRULE_THROWN, "an exception that is no std::exception was thrown");
  }
}

}  // namespace jrule::plugin

#include "compiler/driver/report.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace jrule::driver {

namespace {

bool use_color(ColorMode mode) {
  if (mode != ColorMode::automatic) return mode == ColorMode::always;
  auto const set = [](char const* name) {
    char const* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (set("NO_COLOR")) return false;
  if (set("CLICOLOR_FORCE") || set("FORCE_COLOR")) return true;
  char const* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

}  // namespace

void print(source::Sources const& sources, source::Diagnostics const& diagnostics, Common const& common) {
  for (source::Diagnostic const& diagnostic : diagnostics.sorted()) {
    if (common.format == MessageFormat::json) {
      std::fputs(source::render_json(sources, diagnostic).c_str(), stdout);
    } else {
      std::fputs(source::render_human(sources, diagnostic, {.color = use_color(common.color)}).c_str(), stderr);
    }
  }
}

int status(source::Diagnostics const& diagnostics) {
  int result = exit_ok;
  for (source::Diagnostic const& diagnostic : diagnostics.all()) {
    if (diagnostic.code == source::Code::cannot_read_file) return exit_usage;
    if (source::severity(diagnostic) == source::Severity::error) result = exit_refused;
  }
  return result;
}

void print_error(std::string const& text) { std::fprintf(stderr, "jrule: error: %s\n", text.c_str()); }

void print_error(Error const& error) {
  // A place, if there is one, comes first, so that editors find it.
  if (error.file.empty()) return print_error(error.message);
  if (error.line == 0) {
    std::fprintf(stderr, "%s: error: %s\n", error.file.c_str(), error.message.c_str());
  } else {
    std::fprintf(stderr, "%s:%zu: error: %s\n", error.file.c_str(), error.line, error.message.c_str());
  }
}

}  // namespace jrule::driver

#include "compiler/driver/output.h"

#include <fmt/format.h>

#include <filesystem>

#include "compiler/driver/report.h"
#include "compiler/source/read.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace fs = std::filesystem;

namespace {

std::string escape_for_make(std::string const& path) {
  std::string text;
  for (char const c : path) {
    if (c == ' ' || c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
  }
  return text;
}

// Paths as the command line gives them, relative ones too: a Makefile knows its targets by those.
std::string depfile_text(std::vector<std::string> const& targets, std::vector<std::string> const& sources) {
  std::string text;
  for (std::string const& target : targets) text += escape_for_make(target) + ' ';
  text.back() = ':';
  for (std::string const& source : sources)
    text += " \\\n  " + escape_for_make(fs::path(source).lexically_normal().string());
  return text + '\n';
}

bool same_content(std::string const& path, std::string const& text) {
  auto const old = source::read_file(path);
  return old && *old == text;
}

}  // namespace

int write_outputs(EmitOptions const& options, std::vector<std::string> const& sources,
                  std::vector<Output> const& outputs) {
  std::error_code error;
  for (Output const& output : outputs) {
    for (std::string const& source : sources) {
      if (!fs::equivalent(fs::path(options.directory) / output.name, source, error)) continue;
      print_error(fmt::format("`{}` would be overwritten: choose another folder with `-o`", source));
      return exit_usage;
    }
  }
  fs::create_directories(options.directory, error);
  std::vector<std::string> targets;
  std::vector<FileText> files;
  for (Output const& output : outputs) {
    std::string const path = (fs::path(options.directory) / output.name).string();
    targets.push_back(fs::path(path).lexically_normal().string());
    if (options.write_if_changed && same_content(path, output.text)) continue;
    files.push_back({path, output.text});
  }
  // Last and always: Ninja takes outputs without a depfile for dirty.
  if (!options.depfile.empty()) files.push_back({options.depfile, depfile_text(targets, sources)});
  if (auto const written = write_whole_files(files); !written) {
    print_error(written.error());
    return exit_usage;
  }
  return exit_ok;
}

}  // namespace jrule::driver

// Shared libraries that offer rules (runtime/include/jrule/plugin.h), loaded. The only file that knows dlopen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jrule/map.h"
#include "jrule/plugin.h"
#include "jrule/result.h"

namespace jrule::driver {

/// ".so", ".so.1", ".dylib".
bool is_plugin_path(std::string const& path);

using PluginMap = std::unique_ptr<jrule_map, void (*)(jrule_map*)>;

class Plugin {
 public:
  /// Errors: the file cannot be read (Kind::io); it is no library, has no entry, or one of another version
  /// (Kind::bad_input).
  static Result<Plugin> load(std::string const& path);

  jrule_plugin const& entry() const noexcept { return *entry_; }
  /// The rule of that name, or MODULE:NAME; an error if there is none or more than one.
  Result<std::uint32_t> find_rule(std::string const& name) const;

  // The functions of the entry that the commands use, with results.
  Result<PluginMap> create(std::uint32_t modeler) const;
  Result<PluginMap> read(std::uint32_t modeler, std::string const& path) const;
  Result<void> write(PluginMap const& map, std::string const& path) const;
  Result<void> apply(PluginMap const& map, std::uint32_t rule, std::vector<Dart> const& hooks,
                     std::vector<jrule_value> const& arguments) const;
  Result<void> apply_everywhere(PluginMap const& map, std::uint32_t rule,
                                std::vector<jrule_value> const& arguments) const;
  Result<Summary> summarize(PluginMap const& map) const;
  /// As `jrule apply --at` takes them.
  Result<std::vector<Dart>> select(PluginMap const& map, std::string const& selection) const;

 private:
  using Library = std::unique_ptr<void, void (*)(void*)>;
  Plugin(Library library, jrule_plugin const* entry, std::string path)
      : library_(std::move(library)), entry_(entry), path_(std::move(path)) {}

  Library library_;
  jrule_plugin const* entry_;
  std::string path_;
};

}  // namespace jrule::driver

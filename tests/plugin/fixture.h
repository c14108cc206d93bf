// A loaded plugin, and its functions with C++ arguments.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "jrule/plugin.h"
#include "tests/cli/fixture.h"

namespace jrule::tests {

class WithPlugin : public CommandLine {
 protected:
  using MapPtr = std::unique_ptr<jrule_map, void (*)(jrule_map*)>;

  void SetUp() override;
  /// The plugin's path.
  virtual std::string library() const { return JRULE_PLUGIN; }

  jrule_rule const& rule(std::uint32_t number) const { return plugin_->rules[number]; }
  /// The number of the module's rule; fails the test if it is not there.
  std::uint32_t find(std::string const& module, std::string const& name) const;
  std::uint32_t find(std::string const& name) const { return find("shapes", name); }

  MapPtr empty() const;
  MapPtr read(std::string const& path) const;
  MapPtr cube() const { return read(JRULE_SOURCE_DIR "/tests/data/cube.obj"); }
  /// The map's .jmap text: what a failed call must not change.
  std::string text(MapPtr const& map) const;

  std::int32_t apply(MapPtr const& map, std::uint32_t rule, std::vector<jrule_dart> const& hooks,
                     std::vector<jrule_value> const& arguments);
  std::int32_t everywhere(MapPtr const& map, std::uint32_t rule, std::vector<jrule_value> const& arguments,
                          jrule_progress const* progress = nullptr);
  std::string message() const { return error_.message; }

  static jrule_value by_default() { return {JRULE_DEFAULT, 0, 0, {}}; }
  static jrule_value real(double x) { return {JRULE_REAL, 0, 0, {x}}; }
  static jrule_value integer(std::int64_t n) { return {JRULE_INT, 0, n, {}}; }
  static jrule_value boolean(bool b) { return {JRULE_BOOL, 0, b ? 1 : 0, {}}; }
  static jrule_value triple(std::int32_t type, double x, double y, double z) { return {type, 0, 0, {x, y, z}}; }

  jrule_plugin const* plugin_ = nullptr;
  jrule_error error_{};

 private:
  std::unique_ptr<void, void (*)(void*)> library_{nullptr, nullptr};
};

}  // namespace jrule::tests

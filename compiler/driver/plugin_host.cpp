#include "compiler/driver/plugin_host.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "compiler/driver/selection.h"

namespace jrule::driver {

namespace {

Error to_error(jrule_error const& error) {
  auto const kind = [&] {
    switch (error.code) {
      case JRULE_NOT_APPLICABLE: return Error::Kind::not_applicable;
      case JRULE_IO: return Error::Kind::io;
      case JRULE_NO_MEMORY: return Error::Kind::no_memory;
      case JRULE_CANCELLED: return Error::Kind::cancelled;
      case JRULE_LIMIT: return Error::Kind::limit;
      default: return Error::Kind::bad_input;
    }
  };
  return {kind(), error.message, error.file, error.line};
}

// Runs a function of the entry.
template <class Call>
Result<void> run(Call call) {
  jrule_error error{};
  if (call(&error) == JRULE_OK) return {};
  return tl::unexpected(to_error(error));
}

// What is wrong with an entry; nothing if this program can use it.
std::string fault(jrule_plugin const& entry) {
  if (entry.abi_version != JRULE_PLUGIN_ABI_VERSION) {
    return fmt::format("it is a plugin of version {}, but this jrule takes version {}: build it again",
                       entry.abi_version, JRULE_PLUGIN_ABI_VERSION);
  }
  bool const fits = entry.struct_size >= sizeof(jrule_plugin) && entry.error_size == sizeof(jrule_error) &&
                    entry.value_size == sizeof(jrule_value) && entry.embedding_size == sizeof(jrule_embedding) &&
                    entry.modeler_size == sizeof(jrule_modeler) && entry.hook_size == sizeof(jrule_hook) &&
                    entry.parameter_size == sizeof(jrule_parameter) && entry.node_size == sizeof(jrule_node) &&
                    entry.rule_size == sizeof(jrule_rule) && entry.summary_size == sizeof(jrule_summary) &&
                    entry.progress_size == sizeof(jrule_progress);
  return fits ? "" : "its tables are of other sizes than this jrule's: build it again";
}

}  // namespace

bool is_plugin_path(std::string const& path) {
  std::string const name = std::filesystem::path(path).filename().string();
  return name.ends_with(".so") || name.ends_with(".dylib") || name.find(".so.") != std::string::npos;
}

Result<Plugin> Plugin::load(std::string const& path) {
  if (!std::ifstream(path)) return fail(Error::Kind::io, "cannot read the file", path);
  // Absolute: a bare name would be looked up where libraries are installed.
  std::string const absolute = std::filesystem::absolute(path).string();
  Library library(dlopen(absolute.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* handle) { dlclose(handle); });
  if (!library) {
    char const* const reason = dlerror();
    std::string text = reason == nullptr ? "unknown reason" : reason;
    if (text.starts_with(absolute + ": ")) text.erase(0, absolute.size() + 2);
    return fail(Error::Kind::bad_input, "it cannot be loaded as a plugin: " + text, path);
  }
  auto const* const entry = static_cast<jrule_plugin const*>(dlsym(library.get(), JRULE_PLUGIN_ENTRY));
  if (entry == nullptr)
    return fail(Error::Kind::bad_input, "it is no plugin: it does not export `" JRULE_PLUGIN_ENTRY "`", path);
  if (std::string const what = fault(*entry); !what.empty()) return fail(Error::Kind::bad_input, what, path);
  return Plugin(std::move(library), entry, path);
}

Result<std::uint32_t> Plugin::find_rule(std::string const& name) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t r = 0; r < entry_->rule_count; ++r) {
    jrule_rule const& rule = entry_->rules[r];
    if (rule.name == name || fmt::format("{}:{}", rule.module, rule.name) == name) found.push_back(r);
  }
  if (found.empty())
    return fail(Error::Kind::bad_input, fmt::format("it has no rule or operation `{}`: `jrule info` lists what it has", name),
                path_);
  if (found.size() > 1) {
    return fail(Error::Kind::bad_input,
                fmt::format("{} modules have a rule `{}`: write `{}:{}`", found.size(), name,
                            entry_->rules[found.front()].module, name),
                path_);
  }
  return found.front();
}

Result<PluginMap> Plugin::create(std::uint32_t modeler) const {
  jrule_map* map = nullptr;
  auto const made = run([&](jrule_error* error) { return entry_->create(modeler, &map, error); });
  if (!made) return tl::unexpected(made.error());
  return PluginMap(map, entry_->destroy);
}

Result<PluginMap> Plugin::read(std::uint32_t modeler, std::string const& path) const {
  jrule_map* map = nullptr;
  auto const made = run([&](jrule_error* error) { return entry_->read(modeler, path.c_str(), &map, error); });
  if (!made) return tl::unexpected(made.error());
  return PluginMap(map, entry_->destroy);
}

Result<void> Plugin::write(PluginMap const& map, std::string const& path) const {
  return run([&](jrule_error* error) { return entry_->write(map.get(), path.c_str(), error); });
}

Result<void> Plugin::apply(PluginMap const& map, std::uint32_t rule, std::vector<Dart> const& hooks,
                           std::vector<jrule_value> const& arguments) const {
  return run([&](jrule_error* error) {
    return entry_->apply(map.get(), rule, hooks.data(), static_cast<std::uint32_t>(hooks.size()), arguments.data(),
                         static_cast<std::uint32_t>(arguments.size()), nullptr, 0, error);
  });
}

Result<void> Plugin::apply_everywhere(PluginMap const& map, std::uint32_t rule,
                                      std::vector<jrule_value> const& arguments) const {
  return run([&](jrule_error* error) {
    return entry_->apply_everywhere(map.get(), rule, arguments.data(), static_cast<std::uint32_t>(arguments.size()),
                                    nullptr, error);
  });
}

Result<Summary> Plugin::summarize(PluginMap const& map) const {
  jrule_summary found{};
  std::uint32_t modeler = 0;
  auto const asked = run([&](jrule_error* error) { return entry_->summarize(map.get(), &found, error); });
  if (!asked) return tl::unexpected(asked.error());
  auto const known = run([&](jrule_error* error) { return entry_->modeler_of(map.get(), &modeler, error); });
  if (!known) return tl::unexpected(known.error());
  jrule_modeler const& on = entry_->modelers[modeler];
  Summary summary;
  summary.model = on.model;
  summary.dimension = on.dimension;
  summary.darts = found.darts;
  summary.cells.assign(found.cells, found.cells + on.dimension + 1);
  summary.components = found.components;
  summary.euler = found.euler;
  summary.orientable = found.orientable != 0;
  summary.boundary_darts = found.boundary_darts;
  summary.valid = found.valid != 0;
  return summary;
}

Result<std::vector<Dart>> Plugin::select(PluginMap const& map, std::string const& selection) const {
  std::uint32_t modeler = 0, count = 0;
  auto const known = run([&](jrule_error* error) { return entry_->modeler_of(map.get(), &modeler, error); });
  if (!known) return tl::unexpected(known.error());
  auto const counted = run([&](jrule_error* error) { return entry_->count_darts(map.get(), &count, nullptr, error); });
  if (!counted) return tl::unexpected(counted.error());
  auto const contains = [&](Dart d) {
    std::int32_t there = 0;
    return entry_->contains(map.get(), d, &there, nullptr) == JRULE_OK && there != 0;
  };
  auto const cells = [&](int dimension) -> std::optional<std::vector<Dart>> {
    std::uint32_t size = 0;
    if (entry_->cells(map.get(), dimension, nullptr, 0, &size, nullptr) != JRULE_OK) return {};
    std::vector<Dart> darts(size);
    if (entry_->cells(map.get(), dimension, darts.data(), size, &size, nullptr) != JRULE_OK) return {};
    return darts;
  };
  return driver::select(Selectable{entry_->modelers[modeler].dimension, count, contains, cells}, selection);
}

}  // namespace jrule::driver

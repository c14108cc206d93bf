#include "tests/plugin/fixture.h"

#include <dlfcn.h>

namespace jrule::tests {

void WithPlugin::SetUp() {
  library_ = {dlopen(library().c_str(), RTLD_NOW | RTLD_LOCAL), [](void* handle) { dlclose(handle); }};
  ASSERT_TRUE(library_) << dlerror();
  plugin_ = static_cast<jrule_plugin const*>(dlsym(library_.get(), JRULE_PLUGIN_ENTRY));
  ASSERT_TRUE(plugin_ != nullptr);
  ASSERT_EQ(plugin_->abi_version, JRULE_PLUGIN_ABI_VERSION);
  ASSERT_EQ(plugin_->struct_size, sizeof(jrule_plugin));
}

std::uint32_t WithPlugin::find(std::string const& module, std::string const& name) const {
  for (std::uint32_t r = 0; r < plugin_->rule_count; ++r) {
    if (rule(r).module == module && rule(r).name == name) return r;
  }
  ADD_FAILURE() << "no rule " << module << ":" << name;
  return 0;
}

WithPlugin::MapPtr WithPlugin::empty() const {
  jrule_map* map = nullptr;
  EXPECT_EQ(plugin_->create(0, &map, nullptr), JRULE_OK);
  return {map, plugin_->destroy};
}

WithPlugin::MapPtr WithPlugin::read(std::string const& path) const {
  jrule_map* map = nullptr;
  jrule_error error{};
  EXPECT_EQ(plugin_->read(0, path.c_str(), &map, &error), JRULE_OK) << error.message;
  return {map, plugin_->destroy};
}

std::string WithPlugin::text(MapPtr const& map) const {
  jrule_error error{};
  EXPECT_EQ(plugin_->write(map.get(), (folder() / "text.jmap").c_str(), &error), JRULE_OK) << error.message;
  std::string const written = content("text.jmap");
  std::filesystem::remove(folder() / "text.jmap");
  return written;
}

std::int32_t WithPlugin::apply(MapPtr const& map, std::uint32_t rule, std::vector<jrule_dart> const& hooks,
                               std::vector<jrule_value> const& arguments) {
  return plugin_->apply(map.get(), rule, hooks.data(), static_cast<std::uint32_t>(hooks.size()), arguments.data(),
                        static_cast<std::uint32_t>(arguments.size()), nullptr, 0, &error_);
}

std::int32_t WithPlugin::everywhere(MapPtr const& map, std::uint32_t rule, std::vector<jrule_value> const& arguments,
                                    jrule_progress const* progress) {
  return plugin_->apply_everywhere(map.get(), rule, arguments.data(), static_cast<std::uint32_t>(arguments.size()),
                                   progress, &error_);
}

}  // namespace jrule::tests

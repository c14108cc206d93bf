// Operations of a plugin: listed with the rules, run, cancelled; and `jrule apply --plugin`.
#include "tests/plugin/fixture.h"

namespace jrule::tests {
namespace {

class PluginOperations : public WithPlugin {
 protected:
  std::string library() const override { return JRULE_HOUSES; }
  std::uint32_t house(std::string const& name) const { return find("houses", name); }
  std::int32_t run(MapPtr const& map, std::uint32_t operation, std::vector<jrule_dart> const& darts, std::vector<jrule_value> const& arguments,
                   jrule_progress const* progress = nullptr, std::vector<jrule_dart>* results = nullptr) {
    return plugin_->run(map.get(), operation, darts.data(), static_cast<std::uint32_t>(darts.size()), arguments.data(),
                        static_cast<std::uint32_t>(arguments.size()), progress, results == nullptr ? nullptr : results->data(),
                        results == nullptr ? 0 : static_cast<std::uint32_t>(results->size()), &error_);
  }
};

TEST_F(PluginOperations, AreListedBehindTheRules) {
  ASSERT_EQ(plugin_->rule_count, 6U);
  ASSERT_EQ(plugin_->first_operation, 2U);
  jrule_rule const& roofs = rule(house("roofs"));
  EXPECT_EQ(std::string(roofs.doc), "Puts roofs on two faces.");
  ASSERT_EQ(roofs.hook_count, 2U);
  EXPECT_EQ(std::string(roofs.hooks[0].name), "first");
  EXPECT_EQ(std::string(roofs.hooks[0].doc), "of one face");
  EXPECT_EQ(std::string(roofs.hooks[1].name), "second");
  ASSERT_EQ(roofs.parameter_count, 1U);
  EXPECT_EQ(std::string(roofs.parameters[0].name), "height");
  EXPECT_EQ(roofs.node_count, 0U);
  jrule_rule const& built = rule(house("house"));
  EXPECT_EQ(std::string(built.parameters[0].unit), "m");
  EXPECT_EQ(built.parameters[0].default_kind, JRULE_VALUE_DEFAULT);
  EXPECT_EQ(built.node_count, 1U);
  EXPECT_EQ(rule(house("size")).node_count, 0U);  // what it gives is no dart
}

TEST_F(PluginOperations, Run) {
  MapPtr const map = empty();
  std::vector<jrule_dart> top(1);
  ASSERT_EQ(run(map, house("house"), {}, {by_default()}, nullptr, &top), JRULE_OK) << message();
  EXPECT_EQ(top[0], 24U);
  ASSERT_EQ(apply(map, house("house"), {}, {real(2)}), JRULE_OK) << message();  // as rules are
  jrule_summary summary{};
  ASSERT_EQ(plugin_->summarize(map.get(), &summary, nullptr), JRULE_OK);
  EXPECT_EQ(summary.darts, 64U);
  EXPECT_EQ(summary.components, 2U);
}

TEST_F(PluginOperations, ThatFailLeaveTheMapAsItWas) {
  MapPtr const map = empty();
  ASSERT_EQ(apply(map, find("houses", "square"), {}, {by_default()}), JRULE_OK);
  std::string const before = text(map);
  EXPECT_EQ(run(map, house("roofs"), {0, 1}, {real(1)}), JRULE_NOT_APPLICABLE);
  EXPECT_EQ(message(), "`cone` is not applicable: the 2-arc of `a` has to be a loop, but from dart 1 it leads to dart 9");
  EXPECT_EQ(text(map), before);
  EXPECT_EQ(run(map, find("houses", "square"), {}, {real(1)}), JRULE_BAD_ARGUMENT);
  EXPECT_EQ(run(map, house("roofs"), {0}, {real(1)}), JRULE_BAD_ARGUMENT);
  EXPECT_EQ(everywhere(map, house("size"), {}), JRULE_BAD_ARGUMENT);
  EXPECT_EQ(message(), "`size` is an operation, which is not applied everywhere");
  EXPECT_EQ(text(map), before);
}

TEST_F(PluginOperations, AreCancelledByTheHost) {
  MapPtr const map = empty();
  std::string const before = text(map);
  int asked = 0;
  jrule_progress const progress{[](void* user, double) { return ++*static_cast<int*>(user) < 20 ? 0 : 1; }, &asked};
  EXPECT_EQ(run(map, house("endless"), {}, {integer(0)}, &progress), JRULE_CANCELLED);
  EXPECT_EQ(message(), "`endless` was cancelled: the map is as it was");
  EXPECT_EQ(asked, 20);
  EXPECT_EQ(text(map), before);
}

TEST_F(PluginOperations, OfTheCommandLine) {
  auto const apply_house = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"apply", "--plugin", JRULE_HOUSES, "--out", "out.jmap"});
    return jrule(words);
  };
  Outcome const info = jrule({"info", JRULE_HOUSES});
  EXPECT_TRUE(info.output.starts_with("plugin houses: 1 modeler, 2 rules, 4 operations\n")) << info.output;
  EXPECT_TRUE(info.output.find("\noperation roofs on Solid (houses)\n  Puts roofs on two faces.\n  dart first <>\n    of one face\n  dart second <>\n"
                               "  parameter height : Real\n") != std::string::npos) << info.output;
  Outcome const built = apply_house({"house", "side=2"});
  EXPECT_EQ(built.exit_status, 0) << built.output;
  ASSERT_EQ(jrule({"run", JRULE_SOURCE_DIR "/tests/plugin/rules/houses.jrule:house", "side=2", "--out", "source.jmap"}).exit_status, 0);
  EXPECT_EQ(content("out.jmap"), content("source.jmap"));
  Outcome const none = apply_house({"size", "--in", "out.jmap"});
  EXPECT_EQ(none.exit_status, 2);
  EXPECT_EQ(none.output, "jrule: error: `size` takes 1 dart: give it, `--at dart:3`\n");
  EXPECT_EQ(apply_house({"roofs", "--in", "source.jmap", "--at", "dart:0,dart:1", "height=1"}).exit_status, 1);
}

}  // namespace
}  // namespace jrule::tests

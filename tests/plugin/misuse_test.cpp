// Whatever a host does wrong is an error value, and the map stays as it was.
#include <dlfcn.h>

#include <cmath>
#include <limits>

#include "tests/plugin/fixture.h"

namespace jrule::tests {
namespace {

class Misuse : public WithPlugin {
 protected:
  void expect(std::int32_t code, std::int32_t wanted, std::string const& text) const {
    EXPECT_EQ(code, wanted) << error_.message;
    EXPECT_EQ(error_.code, wanted);
    EXPECT_EQ(std::string(error_.message), text);
  }
  void bad(std::int32_t code, std::string const& text) const { expect(code, JRULE_BAD_ARGUMENT, text); }
};

TEST_F(Misuse, OfCreation) {
  jrule_map* map = nullptr;
  bad(plugin_->create(2, &map, &error_), "there is no modeler 2: the plugin has 2");
  bad(plugin_->create(0, nullptr, &error_), "the pointer to the new map is null");
  bad(plugin_->read(7, "x.obj", &map, &error_), "there is no modeler 7: the plugin has 2");
  bad(plugin_->read(0, nullptr, &map, &error_), "the path is null");
  bad(plugin_->read(0, "x.obj", nullptr, &error_), "the pointer to the new map is null");
  bad(plugin_->copy(nullptr, &map, &error_), "the map is null");
  bad(plugin_->copy(empty().get(), nullptr, &error_), "the pointer to the new map is null");
  EXPECT_EQ(map, nullptr);
  EXPECT_EQ(plugin_->create(2, &map, nullptr), JRULE_BAD_ARGUMENT);  // nobody wants to know why
  plugin_->destroy(nullptr);
}

TEST_F(Misuse, OfFiles) {
  jrule_map* map = nullptr;
  EXPECT_EQ(plugin_->read(0, (folder() / "none.obj").c_str(), &map, &error_), JRULE_IO);
  EXPECT_EQ(std::string(error_.file), (folder() / "none.obj").string());
  file("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  EXPECT_EQ(plugin_->read(0, (folder() / "bad.obj").c_str(), &map, &error_), JRULE_BAD_INPUT);
  EXPECT_EQ(error_.line, 3U) << message();
  EXPECT_EQ(plugin_->read(0, "mesh.soup", &map, &error_), JRULE_BAD_INPUT);
  EXPECT_EQ(map, nullptr);
  MapPtr const some = cube();
  EXPECT_EQ(plugin_->write(some.get(), (folder() / "no" / "folder.obj").c_str(), &error_), JRULE_IO);
  EXPECT_EQ(plugin_->write(some.get(), "mesh.soup", &error_), JRULE_BAD_INPUT);
  bad(plugin_->write(some.get(), nullptr, &error_), "the path is null");
  bad(plugin_->write(nullptr, "a.obj", &error_), "the map is null");
  // The file is told as far as there is room.
  std::string const long_path = std::string(2000, 'x') + ".obj";
  EXPECT_EQ(plugin_->read(0, long_path.c_str(), &map, &error_), JRULE_IO);
  EXPECT_EQ(std::string(error_.file), long_path.substr(0, sizeof(error_.file) - 1));
  std::string e_acute;
  for (int i = 0; i < 600; ++i) e_acute += "\xc3\xa9";
  EXPECT_EQ(plugin_->read(0, (e_acute + ".obj").c_str(), &map, &error_), JRULE_IO);
  EXPECT_EQ(std::string(error_.file), e_acute.substr(0, 510));  // no half of a character
}

TEST_F(Misuse, OfApply) {
  MapPtr const map = cube();
  std::string const before = text(map);
  std::uint32_t const cone = find("cone"), square = find("square"), paint = find("paint");
  bad(apply(map, 99, {}, {}), "there is no rule 99: the plugin has 11");
  bad(apply(map, 0xffffffffU, {}, {}), "there is no rule 4294967295: the plugin has 11");
  bad(apply(map, cone, {}, {by_default()}), "`cone` has 1 hook, not 0");
  bad(apply(map, cone, {0, 1}, {by_default()}), "`cone` has 1 hook, not 2");
  bad(apply(map, square, {0}, {by_default()}), "`square` has 0 hooks, not 1");
  bad(apply(map, cone, {0}, {}), "`cone` has 1 parameter, not 0");
  bad(apply(map, paint, {0}, {real(1)}), "`paint` has 4 parameters, not 1");
  bad(apply(map, cone, {0}, {real(1)}), "the parameter `apex` of `cone` is a Point3, not Real");
  bad(apply(map, cone, {0}, {{77, 0, 0, {}}}), "the parameter `apex` of `cone` is a Point3, not type 77");
  bad(apply(map, cone, {0}, {{-7, 0, 0, {}}}), "the parameter `apex` of `cone` is a Point3, not type -7");
  bad(apply(map, cone, {0}, {triple(JRULE_POINT3, 0, std::nan(""), 0)}),
      "the parameter `apex` of `cone` has a number that is not finite");
  bad(apply(map, square, {}, {real(std::numeric_limits<double>::infinity())}),
      "the parameter `size` of `square` has a number that is not finite");
  bad(apply(map, paint, {0}, {by_default(), by_default(), by_default(), by_default()}),
      "the parameter `paint` of `paint` has no default");
  bad(apply(map, find("outside", "cover"), {0}, {by_default()}),
      "`cover` cannot be called: its parameter `cloud` is of the C++ type `Cloud`");
  bad(plugin_->apply(nullptr, cone, nullptr, 0, nullptr, 0, nullptr, 0, &error_), "the map is null");
  bad(plugin_->apply(map.get(), cone, nullptr, 1, nullptr, 1, nullptr, 0, &error_), "the hooks of `cone` are null");
  jrule_dart const dart = 0;
  bad(plugin_->apply(map.get(), cone, &dart, 1, nullptr, 1, nullptr, 0, &error_), "the parameters of `cone` are null");
  jrule_value const value = by_default();
  jrule_dart darts[3] = {9, 9, 9};
  bad(plugin_->apply(map.get(), cone, &dart, 1, &value, 1, darts, 3, &error_),
      "`cone` gives 4 darts: there has to be room for them, or null and 0");
  bad(plugin_->apply(map.get(), cone, &dart, 1, &value, 1, nullptr, 4, &error_),
      "`cone` gives 4 darts: there has to be room for them, or null and 0");
  EXPECT_EQ(darts[0], 9U);
  EXPECT_EQ(plugin_->apply(map.get(), 99, nullptr, 0, nullptr, 0, nullptr, 0, nullptr), JRULE_BAD_ARGUMENT);

  expect(apply(map, cone, {0}, {value}), JRULE_NOT_APPLICABLE,
         "`cone` is not applicable: the 2-arc of `a` has to be a loop, but from dart 0 it leads to dart " +
             std::to_string([&] {
               jrule_dart to = 0;
               EXPECT_EQ(plugin_->target(map.get(), 0, 2, &to, nullptr), JRULE_OK);
               return to;
             }()));
  for (jrule_dart const absent : {48U, 1000000U, JRULE_NO_DART}) {
    expect(
        apply(map, cone, {absent}, {value}), JRULE_NOT_APPLICABLE,
        "`cone` is not applicable: the map has no dart " + std::to_string(absent) + " to be matched by the hook `a`");
  }
  EXPECT_EQ(text(map), before);
}

TEST_F(Misuse, OfDeletedDarts) {
  MapPtr const map = cube();
  ASSERT_EQ(apply(map, find("open_edge"), {0}, {}), JRULE_OK) << message();
  std::string const before = text(map);
  std::int32_t there = 1;
  ASSERT_EQ(plugin_->contains(map.get(), 0, &there, &error_), JRULE_OK);
  EXPECT_EQ(there, 0);
  jrule_dart to = 0;
  bad(plugin_->target(map.get(), 0, 0, &to, &error_), "the map has no dart 0");
  EXPECT_EQ(apply(map, find("open_edge"), {0}, {}), JRULE_NOT_APPLICABLE);
  EXPECT_EQ(text(map), before);
}

TEST_F(Misuse, OfEverywhere) {
  MapPtr const map = cube();
  std::string const before = text(map);
  bad(everywhere(map, 99, {}), "there is no rule 99: the plugin has 11");
  bad(everywhere(map, find("sew"), {}), "`sew` has 2 hooks: only a rule of one hook can be applied everywhere");
  bad(everywhere(map, find("square"), {real(1)}),
      "`square` has 0 hooks: only a rule of one hook can be applied everywhere");
  bad(everywhere(map, find("cone"), {}), "`cone` has 1 parameter, not 0");
  bad(plugin_->apply_everywhere(nullptr, 0, nullptr, 0, nullptr, &error_), "the map is null");
  EXPECT_EQ(everywhere(map, find("cone"), {by_default()}), JRULE_NOT_APPLICABLE) << message();
  jrule_progress const silent{nullptr, nullptr};
  EXPECT_EQ(everywhere(map, find("cone"), {by_default()}, &silent), JRULE_NOT_APPLICABLE);
  EXPECT_EQ(text(map), before);
}

// A host in C++ whose callback throws, although it must not.
TEST_F(Misuse, ACallbackThatThrows) {
  for (char const* const name : {"open_edge", "quad_subdivision"}) {
    MapPtr const map = cube();
    std::string const before = text(map);
    jrule_progress const progress{[](void*, double) -> std::int32_t { throw 1; }, nullptr};
    expect(everywhere(map, find(name), {}, &progress), JRULE_THROWN,
           "an exception that is no std::exception was thrown");
    EXPECT_EQ(text(map), before);
  }
}

TEST_F(Misuse, CppFromOutsideThatThrows) {
  MapPtr const map = cube();
  std::string const before = text(map);
  std::uint32_t const soak = find("outside", "soak");
  expect(apply(map, soak, {0}, {real(-1), by_default()}), JRULE_THROWN, "negative rain");
  expect(apply(map, soak, {0}, {real(101), by_default()}), JRULE_THROWN,
         "an exception that is no std::exception was thrown");
  expect(everywhere(map, soak, {real(-1), by_default()}), JRULE_THROWN, "negative rain");
  EXPECT_EQ(text(map), before);
}

TEST_F(Misuse, OfMapsOfAnotherModeler) {
  jrule_map* raw = nullptr;
  ASSERT_EQ(plugin_->create(1, &raw, &error_), JRULE_OK);
  MapPtr const sky(raw, plugin_->destroy);
  bad(apply(sky, find("square"), {}, {real(1)}), "`square` works on maps of `Surface`, not of `Sky`");
  // Its values are of a C++ type; it has no text.
  EXPECT_EQ(plugin_->write(sky.get(), (folder() / "sky.jmap").c_str(), &error_), JRULE_BAD_INPUT);
}

TEST_F(Misuse, OfValuesOfCppTypes) {
  jrule_map* raw = nullptr;
  ASSERT_EQ(plugin_->read(1, JRULE_SOURCE_DIR "/tests/data/cube.obj", &raw, &error_), JRULE_OK) << message();
  MapPtr const sky(raw, plugin_->destroy);
  jrule_value value = real(1);
  bad(plugin_->value(sky.get(), 0, 0, &value, &error_), "the values of `cover` are of the C++ type `weather::Cloud`");
  bad(plugin_->set_value(sky.get(), 0, 0, &value, &error_),
      "the values of `cover` are of the C++ type `weather::Cloud`");
}

TEST_F(Misuse, OfQueries) {
  MapPtr const map = cube();
  std::string const before = text(map);
  jrule_dart dart = 0;
  std::uint32_t count = 0;
  std::int32_t there = 0;
  for (std::int32_t const dimension :
       {-1, 3, 9, 10, 300, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
    std::string const d = std::to_string(dimension);
    bad(plugin_->target(map.get(), 0, dimension, &dart, &error_), "the map has no arcs of dimension " + d);
    bad(plugin_->source(map.get(), 0, dimension, &dart, &error_), "the map has no arcs of dimension " + d);
    bad(plugin_->cells(map.get(), dimension, nullptr, 0, &count, &error_), "the map has no cells of dimension " + d);
    bad(plugin_->orbit(map.get(), 0, &dimension, 1, nullptr, 0, &count, &error_),
        "the map has no arcs of dimension " + d);
  }
  for (jrule_dart const absent : {48U, JRULE_NO_DART}) {
    std::string const text = "the map has no dart " + std::to_string(absent);
    jrule_value value{};
    std::int32_t const dimension = 0;
    bad(plugin_->target(map.get(), absent, 0, &dart, &error_), text);
    bad(plugin_->source(map.get(), absent, 0, &dart, &error_), text);
    bad(plugin_->value(map.get(), 0, absent, &value, &error_), text);
    bad(plugin_->set_value(map.get(), 0, absent, &value, &error_), text);
    bad(plugin_->orbit(map.get(), absent, &dimension, 1, nullptr, 0, &count, &error_), text);
    EXPECT_EQ(plugin_->contains(map.get(), absent, &there, &error_), JRULE_OK);
    EXPECT_EQ(there, 0);
  }
  jrule_value value = triple(JRULE_POINT3, 0, 0, std::nan(""));
  bad(plugin_->value(map.get(), 4, 0, &value, &error_), "there is no embedding 4: the map has 4");
  bad(plugin_->set_value(map.get(), 4, 0, &value, &error_), "there is no embedding 4: the map has 4");
  bad(plugin_->set_value(map.get(), 0, 0, &value, &error_), "the embedding `position` has a number that is not finite");
  bad(plugin_->set_value(map.get(), 2, 0, &value, &error_), "the embedding `visits` is a Int, not Point3");
  value.type = JRULE_EXTERN;
  bad(plugin_->set_value(map.get(), 2, 0, &value, &error_), "the embedding `visits` is a Int, not extern");

  std::int32_t const eleven[11] = {};
  bad(plugin_->orbit(map.get(), 0, eleven, 11, nullptr, 0, &count, &error_),
      "an orbit has each dimension once at most");
  bad(plugin_->orbit(map.get(), 0, nullptr, 1, nullptr, 0, &count, &error_), "the pointer to the dimensions is null");
  EXPECT_EQ(plugin_->orbit(map.get(), 5, nullptr, 0, &dart, 1, &count, &error_), JRULE_OK);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(dart, 5U);
  bad(plugin_->orbit(map.get(), 0, eleven, 1, nullptr, 4, &count, &error_), "the pointer to the darts is null");
  bad(plugin_->cells(map.get(), 0, nullptr, 4, &count, &error_), "the pointer to the darts is null");
  bad(plugin_->cells(map.get(), 0, nullptr, 0, nullptr, &error_), "the pointer to the count is null");
  bad(plugin_->target(map.get(), 0, 0, nullptr, &error_), "the pointer to the dart is null");
  bad(plugin_->value(map.get(), 0, 0, nullptr, &error_), "the pointer to the value is null");
  bad(plugin_->set_value(map.get(), 0, 0, nullptr, &error_), "the pointer to the value is null");
  bad(plugin_->contains(map.get(), 0, nullptr, &error_), "the pointer to the answer is null");
  bad(plugin_->summarize(map.get(), nullptr, &error_), "the pointer to the summary is null");
  bad(plugin_->modeler_of(map.get(), nullptr, &error_), "the pointer to the modeler is null");
  EXPECT_EQ(plugin_->count_darts(map.get(), nullptr, nullptr, &error_), JRULE_OK);

  jrule_summary summary{};
  bad(plugin_->target(nullptr, 0, 0, &dart, &error_), "the map is null");
  bad(plugin_->source(nullptr, 0, 0, &dart, &error_), "the map is null");
  bad(plugin_->value(nullptr, 0, 0, &value, &error_), "the map is null");
  bad(plugin_->set_value(nullptr, 0, 0, &value, &error_), "the map is null");
  bad(plugin_->contains(nullptr, 0, &there, &error_), "the map is null");
  bad(plugin_->cells(nullptr, 0, nullptr, 0, &count, &error_), "the map is null");
  bad(plugin_->orbit(nullptr, 0, eleven, 1, nullptr, 0, &count, &error_), "the map is null");
  bad(plugin_->summarize(nullptr, &summary, &error_), "the map is null");
  bad(plugin_->modeler_of(nullptr, &count, &error_), "the map is null");
  bad(plugin_->count_darts(nullptr, &count, &count, &error_), "the map is null");
  EXPECT_EQ(text(map), before);
}

// Two plugins in one program: what one has made the other does not touch.
TEST_F(Misuse, OfMapsOfAnotherLibrary) {
  file("other.so", content(JRULE_PLUGIN));
  std::unique_ptr<void, int (*)(void*)> const library(dlopen((folder() / "other.so").c_str(), RTLD_NOW | RTLD_LOCAL),
                                                      dlclose);
  ASSERT_TRUE(library) << dlerror();
  auto const* const other = static_cast<jrule_plugin const*>(dlsym(library.get(), JRULE_PLUGIN_ENTRY));
  ASSERT_TRUE(other != nullptr && other != plugin_);
  MapPtr const map = cube();
  jrule_summary summary{};
  bad(other->summarize(map.get(), &summary, &error_), "the map is not of this plugin");
  bad(other->apply_everywhere(map.get(), find("quad_subdivision"), nullptr, 0, nullptr, &error_),
      "the map is not of this plugin");
  other->destroy(map.get());  // left alone
  EXPECT_EQ(plugin_->summarize(map.get(), &summary, &error_), JRULE_OK);
  EXPECT_EQ(summary.cells[2], 6U);
}

}  // namespace
}  // namespace jrule::tests

// What `jrule emit` writes depends on the rules and nothing else: not on the run, the working directory or the order of -I.
#include <map>

#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

namespace fs = std::filesystem;

class Emit : public CommandLine {
 protected:
  // The files that a command writes into a folder, by name. Run in `from`.
  std::map<std::string, std::string> written(fs::path const& from, std::string const& out, std::vector<std::string> const& words) const {
    std::vector<std::string> command = {JRULE_EXECUTABLE, "emit"};
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), {"-o", out});
    Outcome const outcome = run(from, command);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    std::map<std::string, std::string> files;
    for (auto const& entry : fs::directory_iterator(from / out)) files[entry.path().filename().string()] = read(entry.path());
    EXPECT_FALSE(files.empty());
    return files;
  }
};

TEST_F(Emit, WritesTheSameAgainFromAnywhere) {
  fs::path const source = fs::canonical(JRULE_SOURCE_DIR), elsewhere = fs::canonical(folder()) / "elsewhere";
  fs::create_directories(elsewhere);
  std::size_t modules = 0;
  for (char const* const rules : {"stdlib/std", "tests/integration/rules"}) {
    for (auto const& entry : fs::directory_iterator(source / rules)) {
      if (entry.path().extension() != ".jrule") continue;
      ++modules;
      std::string const out = entry.path().stem().string(), relative = fs::relative(entry.path(), elsewhere).string();
      EXPECT_EQ(written(elsewhere, out, {"cpp", relative}), written(folder(), out, {"cpp", entry.path().string()})) << relative;
    }
  }
  EXPECT_GT(modules, 10U);
  std::string const terrain = (source / "tests/integration/rules/terrain.jrule").string();
  std::vector<std::string> const plugin = {"plugin", terrain, "--name", "terrain"};
  EXPECT_EQ(written(elsewhere, "plugin", plugin), written(folder(), "plugin", plugin));
}

TEST_F(Emit, TheOrderOfFoldersOfImportsDoesNotMatter) {
  fs::create_directories(folder() / "one");
  fs::create_directories(folder() / "two");
  file("one/meshes.jrule", "modeler Mesh on gmap(2) { embedding position : vertex -> Point3; }\n");
  file("two/edges.jrule", "import meshes;\nrule middle on Mesh {\n  left { hook a <0,2>; }\n"
                          "  right { a <_,2>; b <1,2> { position = mean(<0>(a).position); } a -0- b; }\n}\n");
  file("all.jrule", "import edges;\nimport meshes;\n"
                    "rule loose on Mesh { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; } }\n");
  auto const first = written(folder(), "out.1", {"cpp", "all.jrule", "-I", "one", "-I", "two"});
  EXPECT_EQ(written(folder(), "out.2", {"cpp", "all.jrule", "-I", "two", "-I", "one"}), first);
  EXPECT_EQ(written(folder() / "one", "../out.3", {"cpp", "../all.jrule", "-I", "../two", "-I", "."}), first);
}

}  // namespace
}  // namespace jrule::tests

// `jrule docs`: every module of the library has its page, every rule its picture.
#include <map>
#include <pugixml.hpp>
#include <regex>
#include <set>

#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

namespace fs = std::filesystem;

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

class Docs : public CommandLine {
 protected:
  static std::vector<std::string> library() {
    std::vector<std::string> paths;
    for (auto const& entry : fs::directory_iterator(fs::canonical(JRULE_SOURCE_DIR) / "stdlib/std")) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  std::map<std::string, std::string> written(fs::path const& from, std::string const& out, std::vector<std::string> const& files) const {
    std::vector<std::string> command = {JRULE_EXECUTABLE, "docs", "-o", out};
    command.insert(command.end(), files.begin(), files.end());
    Outcome const outcome = run(from, command);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "");
    std::map<std::string, std::string> pages;
    for (auto const& entry : fs::directory_iterator(from / out)) pages[entry.path().filename().string()] = read(entry.path());
    return pages;
  }

  static pugi::xml_document parsed(std::string const& page) {
    pugi::xml_document document;
    auto const result = document.load_string(page.c_str());
    EXPECT_TRUE(result) << result.description() << " at byte " << result.offset;
    return document;
  }

  static pugi::xml_node section(pugi::xml_document const& page, std::string const& name) {
    return page.child("html").child("body").find_child_by_attribute("section", "id", name.c_str());
  }

  /// All text within, one piece after the other.
  static std::string text(pugi::xml_node const& node) {
    std::string all;
    for (auto const& part : node.select_nodes(".//text()")) all += part.node().value();
    return all;
  }

  static void check_links(std::map<std::string, std::string> const& pages) {
    std::size_t links = 0;
    for (auto const& [name, bytes] : pages) {
      pugi::xml_document const page = parsed(bytes);
      for (auto const& found : page.select_nodes("//a/@href")) {
        ++links;
        std::string const href = found.attribute().value();
        std::size_t const hash = std::min(href.find('#'), href.size());
        std::string const file = hash == 0 ? name : href.substr(0, hash);
        ASSERT_TRUE(pages.contains(file)) << name << ": " << href;
        if (hash == href.size()) continue;
        pugi::xml_document const target = parsed(pages.at(file));
        EXPECT_TRUE(section(target, href.substr(hash + 1))) << name << ": " << href;
      }
    }
    EXPECT_GT(links, 300U);
    EXPECT_TRUE(contains(pages.at("surface.html"), "<a href=\"mesh.html\"><code>std.mesh</code></a>"));
    // Of `insert_vertex`: "Undoes insert_vertex."
    EXPECT_TRUE(contains(pages.at("surface.html"), "Undoes <a href=\"#insert_vertex\">insert_vertex</a>."));
  }

  std::string page(std::string const& source) const {
    file("a.jrule", source);
    Outcome const outcome = jrule({"docs", "a.jrule"});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    return outcome.output;
  }
};

// The items of that kind in a source file, in canonical layout.
std::set<std::string> items(std::string const& kind, std::string const& source) {
  std::set<std::string> names;
  std::regex const item("(^|\n)" + kind + " ([A-Za-z0-9_]+)");
  for (std::sregex_iterator i(source.begin(), source.end(), item), end; i != end; ++i) names.insert((*i)[2].str());
  return names;
}

// And links lead somewhere: all in one, since the pages of the whole library take a while under sanitizers.
TEST_F(Docs, EveryRuleOfTheLibraryHasItsSectionAndItsPicture) {
  std::vector<std::string> const files = library();
  auto const pages = written(folder(), "out", files);
  ASSERT_EQ(pages.size(), files.size() + 1);
  ASSERT_TRUE(pages.contains("index.html"));
  std::size_t rules = 0, operations = 0;
  for (std::string const& path : files) {
    std::string const source = read(path), name = fs::path(path).stem().string() + ".html";
    ASSERT_TRUE(pages.contains(name));
    pugi::xml_document const page = parsed(pages.at(name));
    for (std::string const& rule : items("rule", source)) {
      ++rules;
      pugi::xml_node const own = section(page, rule);
      EXPECT_TRUE(own) << rule;
      EXPECT_TRUE(own.child("p")) << rule << " has no documentation";
      pugi::xml_node const picture = own.child("figure").child("svg");
      EXPECT_EQ(std::distance(picture.children("g").begin(), picture.children("g").end()), 2) << rule;
      EXPECT_TRUE(picture.child("title").text().get() == rule + " on " || contains(picture.child_value("title"), rule)) << rule;
      EXPECT_TRUE(contains(text(own), "Proved")) << rule;
      EXPECT_TRUE(contains(own.child_value("pre"), "rule " + rule)) << rule;
      EXPECT_FALSE(contains(text(own), "nan")) << rule;
    }
    for (std::string const& operation : items("operation", source)) {
      ++operations;
      EXPECT_TRUE(section(page, operation).child("figure")) << operation;
    }
    for (std::string const& modeler : items("modeler", source)) EXPECT_TRUE(section(page, modeler).child("table")) << modeler;
  }
  EXPECT_GT(rules, 140U);
  EXPECT_GT(operations, 10U);
  check_links(pages);
}

TEST_F(Docs, TheSameBytesFromAnywhere) {
  std::string const modules = fs::canonical(JRULE_SOURCE_DIR) / "stdlib/std";
  std::vector<std::string> const files = {modules + "/mesh.jrule", modules + "/surface.jrule", modules + "/volume_halfedges.jrule"};
  std::vector<std::string> relative;
  fs::create_directories(folder() / "elsewhere");
  for (std::string const& file : files) relative.push_back(fs::relative(file, fs::canonical(folder()) / "elsewhere").string());
  EXPECT_EQ(written(folder(), "out", files), written(folder() / "elsewhere", "out", relative));
}

TEST_F(Docs, APageTellsWhatIsProvedAndShowsItOnASurface) {
  std::string const bytes = page(R"(/// Rules on meshes.

/// A mesh.
modeler Mesh on gmap(2) {
  /// Where it lies.
  embedding position : vertex -> Point3 { merge mean; }
}

/// Raises a pyramid.
///
/// In a second paragraph.
rule raise(
    /// [m] how high
    height: Real,
    share: Real = 1 / 2) on Mesh {
  left { /// the face
    hook a <0,1>; }
  right {
    a <0,_>; b <_,2>;
    c <1,2> { position = mean(<0,1>(a).position) + Vec3(0, height, 0); }
    a -1- b -0- c;
  }
}

/// All faces.
rule kis on Mesh {
  left { hook a <0,1,2>; }
  right { a <0,_,2>; b <_,2,_>; c <1,2,_> { position = mean(<0,1>(a).position); } a -1- b -0- c; }
}

rule sew[i] on gmap(n) {
  left { hook a <0..i-2,i+2..n>; hook b <0..i-2,i+2..n>; a -(i)- a; b -(i)- b; }
  right { a; b; a -(i)- b; }
}

operation rise(d: Dart, height: Real = 1) on Mesh -> Dart { let top = raise(d, height); return top.c; }
)");
  pugi::xml_document const document = parsed(bytes);
  EXPECT_TRUE(contains(bytes, "<h1>a</h1>\n<p>Rules on meshes.</p>"));
  EXPECT_TRUE(contains(text(section(document, "Mesh")), "Where it lies."));

  pugi::xml_node const raise = section(document, "raise");
  EXPECT_EQ(raise.child("h2").child("code").text().get(), std::string("raise(height: Real, share: Real = 1 / 2) on Mesh"));
  EXPECT_EQ(raise.select_nodes("p[.='In a second paragraph.']").size(), 1U);
  std::string const told = text(raise);
  for (char const* const part : {"how high", "the face", "its pattern is the orbit <0,1> of ", "raise(height: 0.5)", "at a face of a cube"}) {
    EXPECT_TRUE(contains(told, part)) << part << " in " << told;
  }
  EXPECT_EQ(raise.select_nodes("figure/svg").size(), 1U);
  EXPECT_EQ(raise.select_nodes("figure/div/svg").size(), 2U);
  // The cube has six faces; one of them becomes four.
  EXPECT_EQ(raise.select_nodes("figure/div/svg[1]//polygon").size(), 6U);
  EXPECT_EQ(raise.select_nodes("figure/div/svg[2]//polygon").size(), 9U);

  std::string const whole = text(section(document, "kis"));
  EXPECT_TRUE(contains(whole, "applied to whole components; may be applied everywhere at once.")) << whole;
  EXPECT_TRUE(contains(whole, "V' = V + F")) << whole;
  // As `explain` says it.
  EXPECT_TRUE(contains(jrule({"explain", "a.jrule:kis"}).output, "V' = V + F"));

  pugi::xml_node const sew = section(document, "sew");
  EXPECT_EQ(sew.child("h2").child("code").text().get(), std::string("sew[i] on gmap(n)"));
  EXPECT_TRUE(contains(text(sew.child("figure")), "sew[2] on gmap(2)"));
  EXPECT_TRUE(contains(text(section(document, "rise")), "rise on a cube"));
}

TEST_F(Docs, DocumentationIsTextWhateverIsInIt) {
  std::string const bytes = page(R"(/// Less < than & `code <x>` then one ` alone, and ]]> "quoted" <script>no</script>: see `other_one` and other_one.
/// - first
/// - second `item`
rule odd(/// <p> of it
    t: Bool = 1 < 2) on gmap(2) {
  left { hook a <0,1,2>; require 1 < 2 and t; } right { a; }
}
rule other_one on gmap(2) { left { } right { } }
)");
  pugi::xml_document const document = parsed(bytes);
  pugi::xml_node const odd = section(document, "odd");
  EXPECT_TRUE(contains(text(odd), "Less < than & code <x> then one ")) << text(odd);
  EXPECT_TRUE(contains(text(odd), "]]> \"quoted\" <script>no</script>: see "));
  EXPECT_EQ(document.select_nodes("//script").size(), 0U);
  EXPECT_EQ(odd.select_nodes("ul/li").size(), 2U);
  EXPECT_TRUE(contains(text(odd), "<p> of it"));
  EXPECT_GE(document.select_nodes("//section[@id='odd']//p//a[@href='#other_one']").size(), 1U);
  // The lines at the top are the documentation of the first rule, and so not the file's.
  EXPECT_TRUE(contains(bytes, "<h1>a</h1>\n<table>")) << bytes.substr(0, 3000);
}

TEST_F(Docs, AnOperationWithoutEndIsNotShown) {
  std::string const bytes = page(R"(modeler Mesh on gmap(2) { embedding position : vertex -> Point3; }
rule grow on Mesh {
  left { hook a <0,1>; }
  right { a <0,_>; b <_,2>; c <1,2> { position = mean(<0,1>(a).position); } a -1- b -0- c; }
}
operation idle on Mesh { while 1 < 2 { } }
operation growing(d: Dart) on Mesh { while 1 < 2 { grow(d); } }
)");
  pugi::xml_document const document = parsed(bytes);
  for (char const* const name : {"idle", "growing"}) {
    EXPECT_TRUE(section(document, name)) << name;
    EXPECT_FALSE(section(document, name).child("figure")) << name;
  }
}

TEST_F(Docs, NothingIsWrittenOfFilesWithErrors) {
  file("good.jrule", "rule r on gmap(2) { left { hook a <0>; } right { a; } }\n");
  file("bad.jrule", "rule r on gmap(2) { left { hook a <0>; } right { a <1>; } }\n");
  file("empty.jrule", "");
  file("plain", "a file");
  auto const before = files();
  auto const fails = [&](int status, std::string const& part, std::vector<std::string> words) {
    words.insert(words.begin(), "docs");
    Outcome const outcome = jrule(words);
    EXPECT_EQ(outcome.exit_status, status) << outcome.output;
    EXPECT_TRUE(contains(outcome.output, part)) << outcome.output;
    EXPECT_EQ(files(), before);
  };
  fails(1, "[J0305]", {"good.jrule", "bad.jrule", "-o", "out"});
  fails(1, "[J0003]", {"empty.jrule", "-o", "out"});
  fails(2, "[J0001]", {"good.jrule", "no-such.jrule", "-o", "out"});
  fails(2, "-o DIR", {"good.jrule", "bad.jrule"});
  fails(2, "plain", {"good.jrule", "-o", "plain"});
  fails(2, "would have one page", {"good.jrule", "./good.jrule", "-o", "out"});
  fails(2, "would be the index", {"good.jrule", "index.jrule", "-o", "out"});
  fails(2, "FILE", {});
  file("source.html", content("good.jrule"));
  EXPECT_EQ(jrule({"docs", "source.html", "-o", "."}).exit_status, 2);
  EXPECT_EQ(content("source.html"), content("good.jrule"));
}

}  // namespace
}  // namespace jrule::tests

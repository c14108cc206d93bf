#include "compiler/syntax/parse.h"

#include <gtest/gtest.h>

#include <string>

#include "compiler/syntax/format.h"
#include "tests/unit/parsed.h"
#include "tests/unit/syntax_examples.h"

namespace jrule {
namespace {

using tests::errors;
using tests::Lines;
using tests::parse;
using tests::Parsed;

/// The dump of the expression, by way of a `require`.
std::string expression(std::string const& text) {
  auto const parsed = parse("rule r on S { left { require " + text + "; } right { } }");
  EXPECT_EQ(errors(parsed), Lines{}) << text;
  if (parsed.file.items.empty()) return {};
  auto const dump = syntax::dump(parsed.file);
  auto const begin = dump.find("require ") + 8;
  return dump.substr(begin, dump.find('\n', begin) - begin);
}

ast::Rule const& rule(Parsed const& parsed, std::size_t item) {
  return std::get<ast::Rule>(parsed.file.items.at(item));
}

// ---- Right texts ----

TEST(Parse, surface_example) {
  auto const parsed = parse(std::string(tests::surface_example));
  EXPECT_EQ(errors(parsed), Lines{});
  ASSERT_EQ(parsed.file.items.size(), 4U);

  auto const& surface = std::get<ast::Modeler>(parsed.file.items[0]);
  EXPECT_EQ(surface.doc, "Surfaces in space.");
  EXPECT_EQ(surface.model.name.text, "gmap");
  ASSERT_EQ(surface.embeddings.size(), 2U);
  EXPECT_EQ(surface.embeddings[0].type.name.text, "Point3");
  EXPECT_EQ(surface.embeddings[0].default_value, nullptr);
  EXPECT_NE(surface.embeddings[1].default_value, nullptr);
  EXPECT_EQ(surface.embeddings[1].merge->text, "mean");

  auto const& quads = rule(parsed, 1);
  EXPECT_EQ(quads.doc, "Splits every n-gon of a surface into n quads (paper, Fig. 29).");
  ASSERT_EQ(quads.left.items.size(), 1U);
  auto const& hook = std::get<ast::Node>(quads.left.items[0]);
  EXPECT_TRUE(hook.hook);
  EXPECT_EQ(hook.decoration->elements.size(), 3U);
  ASSERT_EQ(quads.right.items.size(), 5U);
  auto const& a = std::get<ast::Node>(quads.right.items[0]);
  EXPECT_TRUE(std::holds_alternative<ast::Removed>(a.decoration->elements[0].value));
  auto const& chain = std::get<ast::ArcChain>(quads.right.items[4]);
  EXPECT_EQ(chain.nodes.size(), 4U);
  EXPECT_EQ(chain.steps.size(), 3U);

  EXPECT_EQ(rule(parsed, 2).parameters[0].type.name.text, "Point3");
  EXPECT_FALSE(std::get<ast::Node>(rule(parsed, 2).right.items[0]).decoration.has_value());
  EXPECT_EQ(rule(parsed, 3).left.items.size(), 4U);
}

TEST(Parse, halfedges_example) {
  auto const parsed = parse(std::string(tests::halfedges_example));
  EXPECT_EQ(errors(parsed), Lines{});
  auto const& modeler = std::get<ast::Modeler>(parsed.file.items.at(0));
  EXPECT_EQ(std::get<ast::CellName>(modeler.embeddings[0].orbit.value).kind, ast::CellName::Kind::vertex);
  auto const& right = rule(parsed, 1).right.items;
  ASSERT_EQ(right.size(), 10U);
  auto const& step = std::get<ast::ArcChain>(right[5]).steps[0];
  EXPECT_EQ(step.direction, ast::ArcStep::Direction::forward);
  EXPECT_TRUE(step.word->letters[0].conjugate);
  EXPECT_EQ(parsed.sources.text(step.span), "-1[~1]->");
  EXPECT_EQ(std::get<ast::ArcChain>(right[8]).steps[0].direction, ast::ArcStep::Direction::both);
}

TEST(Parse, everything_example) {
  auto const parsed = parse(std::string(tests::everything_example));
  EXPECT_EQ(errors(parsed), Lines{});
  EXPECT_EQ(syntax::dump(parsed.file), R"(import std.surface
import std.volume.face
extern type Soil in "geo/soil.hpp" as "geo::Soil"
extern fn hardness -> Real in "geo/\"soil\".hpp" as "geo::hardness"
  parameter x: Soil
  parameter at: [Point3]
modeler Bare on gmap(3)
rule sew on gmap(n)
  doc "Sews two cells.\nOf any dimension."
  dimension i
  dimension j
  parameter k: Real = (negate (real 1.5e3))
  parameter all: Int
  left
    hook a <0..i-2,i+2..n>
    hook b <>
    arcs a -i- a
    arcs t <-d[w]- s <-2- r
    arcs a -(i-2)[2,~1]-> b -0[]- c
    require (or (and (less (member a x) (negate 1)) (not (equal (member b y) 2))) (member c z))
    let q = (subtract (add (member (walk a [~1]) pos) (multiply (member (walk a [0,1]) pos) (negate (member (walk a [0]) pos)))) (divide (index (member r c) d) (member (walk a [i]) pos)))
  right
    node a
      doc "Carried over."
      position = (comprehension mean (call mean (member (orbit <0,1> f) position)) for f in (orbit <1,2> a by <1>))
    node b
      color = (if (greater q 1) red (if (greater q 2) green blue))
    node k <_,~1,[2,~1],~i+2,0..n>
operation house on Bare -> Dart
  parameter side: Real = (real 1.0)
  body
    let base = (call square side)
    let first = (call cone (member base a) apex: (call Point3 0 0 (negate side)))
    for e in (orbit connected (member base a) by <0,2,3>)
      do (call round e)
    if (equal (call count (orbit <0,1> (member base a) by <0>)) 4)
      then
        assign min = max
      else
        if (call any (member (orbit cell(i) (member base a)) flag))
          then
            fail "no \\ \"face\"\n"
          else
            return
    apply_all (call sew[i-2,3] a b) on (orbit vertex (member base a))
    try
      body
        do (call sew[2] a b)
      else
        while (not (and true false))
          assign (index (member r c) d) = (multiply (add 1 2) 3)
    return (member base a)
)");
}

TEST(Parse, models_example) {
  auto const parsed = parse(std::string(tests::models_example));
  EXPECT_EQ(errors(parsed), Lines{});
  auto const& omap = std::get<ast::Model>(parsed.file.items.at(1));
  EXPECT_EQ(omap.parameter->text, "n");
  EXPECT_TRUE(std::holds_alternative<ast::Range>(omap.dimensions.at(0).value));
  EXPECT_EQ(omap.oriented.size(), 1U);
  EXPECT_EQ(std::get<ast::ExchangeWhere>(omap.exchanges.at(0).value).j.text, "j");
  EXPECT_FALSE(omap.closed.has_value());
  EXPECT_TRUE(std::get<ast::Model>(parsed.file.items.at(3)).closed.has_value());
  auto const& mine = std::get<ast::Model>(parsed.file.items.at(4));
  EXPECT_FALSE(mine.parameter.has_value());
  EXPECT_EQ(std::get<ast::ExchangePairs>(mine.exchanges.at(0).value).pairs.size(), 2U);
}

TEST(Parse, precedence) {
  EXPECT_EQ(expression("a or b and not c < d + e * -f.x"),
            "(or a (and b (not (less c (add d (multiply e (negate (member f x))))))))");
  EXPECT_EQ(expression("a - b - c"), "(subtract (subtract a b) c)");
  EXPECT_EQ(expression("a / b * c"), "(multiply (divide a b) c)");
  EXPECT_EQ(expression("a - (b - c)"), "(subtract a (subtract b c))");
  EXPECT_EQ(expression("not not - - a"), "(not (not (negate (negate a))))");
  EXPECT_EQ(expression("if a then b else c or d"), "(if a b (or c d))");
  EXPECT_EQ(expression("-a@0.p"), "(negate (member (walk a [0]) p))");
  EXPECT_EQ(expression("f(x)[0].y"), "(member (index (call f x) 0) y)");
}

TEST(Parse, lexical_corners) {
  EXPECT_EQ(expression("a <-1"), "(less a (negate 1))");
  EXPECT_EQ(expression("a@0.position"), "(member (walk a [0]) position)");
  EXPECT_EQ(expression("a@1.e5"), "(member (walk a [1]) e5)");
  EXPECT_EQ(expression("a@[]"), "(walk a [])");
  EXPECT_EQ(expression("1e5 + 0.5E-3"), "(add (real 1e5) (real 0.5E-3))");
  EXPECT_EQ(expression("\"a // b /* c \\\" é\""), "\"a // b /* c \\\" é\"");
  EXPECT_EQ(expression("a /* b\n * c */ + // d\n e"), "(add a e)");
  EXPECT_EQ(expression("<0>(a) < <1>(b)"), "(less (orbit <0> a) (orbit <1> b))");
  EXPECT_EQ(expression("min(all, any) + first * position"), "(add (call min all any) (multiply first position))");
}

TEST(Parse, spans_are_bytes_of_the_file) {
  auto const parsed = parse("// é\nrule r on S { left { require f(\"ü\", ( a + b ) * c); } right { } }");
  EXPECT_EQ(errors(parsed), Lines{});
  auto const& require = std::get<ast::Require>(rule(parsed, 0).left.items.at(0));
  EXPECT_EQ(parsed.sources.text(require.span), "require f(\"ü\", ( a + b ) * c);");
  auto const& call = std::get<ast::Call>(require.condition->value);
  EXPECT_EQ(parsed.sources.text(call.arguments.at(1).value->span), "( a + b ) * c");
  auto const& product = std::get<ast::Binary>(call.arguments.at(1).value->value);
  EXPECT_EQ(parsed.sources.text(product.op_span), "*");
  EXPECT_EQ(parsed.sources.text(product.left->span), "a + b");
  EXPECT_EQ(parsed.sources.text(rule(parsed, 0).left.span), "{ require f(\"ü\", ( a + b ) * c); }");
}

TEST(Parse, requirements_keep_their_words) {
  auto const text = [](std::string const& condition) {
    auto const parsed = parse("// é\nrule r on S { left { require " + condition + "; } right { } }");
    EXPECT_EQ(errors(parsed), Lines{});
    return std::get<ast::Require>(rule(parsed, 0).left.items.at(0)).text;
  };
  EXPECT_EQ(text("a.x<1 and( b )"), "a.x<1 and( b )");
  EXPECT_EQ(text("  a /* b\n * c */ +\t\r\n // d\n /// f\n  /*g*/e  /* h */ "), "a + e");
  EXPECT_EQ(text("f(\"ü  /* */\", /* é */ x)"), "f(\"ü  /* */\", x)");
  EXPECT_EQ(text("true"), "true");
}

TEST(Parse, byte_order_mark_and_line_ends) {
  auto const expected = syntax::dump(parse(std::string(tests::surface_example)).file);
  std::string dos = "\xEF\xBB\xBF";
  std::string mac;
  for (char c : tests::surface_example) {
    dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  EXPECT_EQ(syntax::dump(parse(dos).file), expected);
  EXPECT_EQ(syntax::dump(parse(mac).file), expected);
}

TEST(Parse, documentation) {
  auto const parsed = parse(R"(/// not this

///   Indented,
///
/// and more.
//// no documentation
// nor this

rule r on S { left { } right {
  a;  /// of b
  b;
} }
/// of nothing
)");
  EXPECT_EQ(errors(parsed), Lines{});
  EXPECT_EQ(rule(parsed, 0).doc, "  Indented,\n\nand more.");
  EXPECT_EQ(std::get<ast::Node>(rule(parsed, 0).right.items.at(0)).doc, "");
  EXPECT_EQ(std::get<ast::Node>(rule(parsed, 0).right.items.at(1)).doc, "of b");
}

}  // namespace
}  // namespace jrule

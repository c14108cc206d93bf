// What the parser says about wrong texts, and that it survives all of them.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/parsed.h"
#include "tests/unit/syntax_examples.h"

namespace jrule {
namespace {

using tests::errors;
using tests::errors_of;
using tests::Lines;
using tests::parse;

ast::Rule const& rule(tests::Parsed const& parsed, std::size_t item) {
  return std::get<ast::Rule>(parsed.file.items.at(item));
}

/// The errors of a rule with this text as its right side, which starts at 1:32.
Lines errors_on_right(std::string const& text) { return errors_of("rule r on S { left { } right { " + text + " } }"); }

// ---- Files ----

TEST(ParseErrors, files) {
  EXPECT_EQ(errors_of(""), (Lines{"1:1 J0003 the file has no items"}));
  EXPECT_EQ(errors_of("// only\n/* comments */\n"), (Lines{"1:1 J0003 the file has no items"}));
  EXPECT_EQ(errors_of("modeler M on gmap(2);\n// caf\xE9"),
            (Lines{"2:7 J0002 the file is not UTF-8: byte 0xE9 at offset 28 (line 2)"}));
  EXPECT_EQ(errors_of("\xED\xA0\x80"), (Lines{"1:1 J0002 the file is not UTF-8: byte 0xED at offset 0 (line 1)"}));
  EXPECT_EQ(errors_of(std::string("rule\0x", 6)),
            (Lines{"1:5 J0002 the file is not text: it has the control character byte 0x00 at offset 4 (line 1)"}));
  EXPECT_EQ(errors_of(std::string((16U << 20U) + 1, ' ')),
            (Lines{"1:1 J0006 the file has 16777217 bytes; the limit is 16777216 (16 MiB)"}));
  EXPECT_EQ(errors_of("import a;\nimport b" + std::string(1U << 20U, ' ') + ";"),
            (Lines{"2:1 J0006 this item has 1048585 bytes; the limit is 1048576"}));
}

// ---- Tokens ----

TEST(ParseErrors, tokens) {
  EXPECT_EQ(errors_of("rule r on S { /* left"),
            (Lines{"1:15 J0102 this comment is not closed; the rest of the file is in it"}));
  EXPECT_EQ(errors_of("import a; /*/ import b;"),
            (Lines{"1:11 J0102 this comment is not closed; the rest of the file is in it"}));
  EXPECT_EQ(errors_on_right("a%; b ππ;"),
            (Lines{"1:33 J0104 unexpected character `%`", "1:38 J0104 unexpected character `π`"}));
  EXPECT_EQ(errors_on_right("a { c = \"red; }"), (Lines{"1:40 J0105 this string is not closed on its line"}));
  EXPECT_EQ(errors_on_right("a { c = \"red\\\";\n }"), (Lines{"1:40 J0105 this string is not closed on its line"}));
  EXPECT_EQ(errors_on_right("a { c = 9223372036854775807 + 9223372036854775808; }"),
            (Lines{"1:62 J0106 the number `9223372036854775808` is too large"}));
  EXPECT_EQ(errors_on_right("a <99999999999999999999>; b { c = 1e999; }"),
            (Lines{"1:35 J0106 the number `99999999999999999999` is too large",
                   "1:66 J0106 the number `1e999` is too large or too small for a double"}));
  EXPECT_EQ(errors_on_right("a { c = \"a\\qb\"; }"), (Lines{"1:42 J0101 unknown escape in a string"}));
}

// ---- Statements ----

TEST(ParseErrors, statements) {
  EXPECT_EQ(errors_on_right("a <0,1> b;"), (Lines{"1:39 J0101 expected `;` after the node `a`, found `b`"}));
  EXPECT_EQ(errors_on_right("a <0,1>"), (Lines{"1:39 J0101 expected `;` after the node `a`, found `}`"}));
  EXPECT_EQ(errors_on_right("a -0- b"), (Lines{"1:39 J0101 expected `;` after the arc, found `}`"}));
  EXPECT_EQ(errors_on_right("a <0 1>;"), (Lines{"1:37 J0101 expected `,` or `>` after `0`, found `1`"}));
  EXPECT_EQ(errors_on_right("a <0,>;"), (Lines{"1:37 J0101 expected a dimension, `_` or a word after `,`, found `>`"}));
  EXPECT_EQ(errors_on_right("a -- b;"), (Lines{"1:35 J0101 expected a dimension after `-`, found `-`"}));
  EXPECT_EQ(errors_on_right("a -0- 1;"), (Lines{"1:38 J0101 expected a name after `-`, found `1`"}));
  EXPECT_EQ(errors_on_right("a <-0-> b;"), (Lines{"1:37 J0101 expected `[` or `-` after `0`, found `->`"}));
  EXPECT_EQ(errors_on_right("a <;"),
            (Lines{"1:35 J0101 expected an orbit type such as `<0,1>` or an arc such as `<-0-` "
                   "after the node, found `;`"}));
  EXPECT_EQ(errors_on_right("let = 3;"), (Lines{"1:36 J0101 expected a name after `let`, found `=`"}));
  EXPECT_EQ(errors_on_right("a { p = ; q = b c; }"),
            (Lines{"1:40 J0101 expected an expression after `=`, found `;`",
                   "1:48 J0101 expected `;` after the value of `q`, found `c`"}));
  EXPECT_EQ(errors_on_right("require a < b < c;"), (Lines{"1:46 J0101 expected `;` after the condition, found `<`"}));
  EXPECT_EQ(errors_on_right("type;"), (Lines{"1:32 J0101 expected a node, an arc or `}`, found the keyword `type`"}));
}

TEST(ParseErrors, items) {
  EXPECT_EQ(errors_of("import std.surface\nmodeler M on gmap(2);"),
            (Lines{"1:19 J0101 expected `;` after the name of the module, found `modeler`"}));
  EXPECT_EQ(errors_of("import std."),
            (Lines{"1:12 J0101 expected the name of a module after `.`, found the end of the file"}));
  EXPECT_EQ(errors_of("modeler M on gmap(2)"),
            (Lines{"1:21 J0101 expected `;` or `{` after the modeler `M`, found the end of the file"}));
  EXPECT_EQ(errors_of("modeler M on gmap(2) { embedding p : 0 -> T; }"),
            (Lines{"1:38 J0101 expected an orbit type after `:`, found `0`"}));
  EXPECT_EQ(errors_of("modeler M on gmap(2) { embedding p : <0> -> T { default 1; default 2; merge a; merge b; } }"),
            (Lines{"1:60 J0101 a second `default` for the embedding `p`",
                   "1:80 J0101 a second `merge` for the embedding `p`"}));
  EXPECT_EQ(errors_of("model m { exchange (1, j) where j < 2; }"),
            (Lines{"1:21 J0101 expected a name: `where` speaks about the two dimensions by their names"}));
  EXPECT_EQ(errors_of("rule if on S { left { } right { } }"),
            (Lines{"1:6 J0101 expected a name after `rule`, found the keyword `if`"}));
  EXPECT_EQ(errors_of("rule r on S { right { } }"), (Lines{"1:15 J0101 expected `left`, found the keyword `right`"}));
  EXPECT_EQ(errors_of("extern type A in geo as \"x\";"),
            (Lines{"1:18 J0101 expected a string after `in`, found `geo`"}));
  EXPECT_EQ(errors_of("ruel r on S { left { } right { } }"), (Lines{"1:1 J0101 expected an item, found `ruel`"}));
}

TEST(ParseErrors, operations) {
  auto const of = [](std::string const& text) { return errors_of("operation o on S { " + text + " }"); };
  EXPECT_EQ(of("if a { return } else b = 1; c;"),
            (Lines{"1:34 J0101 expected an expression or `;` after `return`, found `}`",
                   "1:41 J0101 expected `if` or `{` after `else`, found `b`"}));
  EXPECT_EQ(of("a = b"), (Lines{"1:25 J0101 expected `;` after the statement, found `}`"}));
  EXPECT_EQ(of("f(a b); g(1, 2; h(;"), (Lines{"1:24 J0101 expected `)` or `,` after `a`, found `b`",
                                              "1:34 J0101 expected `)` or `,` after `2`, found `;`",
                                              "1:38 J0101 expected an expression or `)` after `(`, found `;`"}));
  EXPECT_EQ(
      of("f(1: 2); a.b(c); x[1, 2]; sew[f(x)](a); sew[1-2-(3+4)](a);"),
      (Lines{"1:22 J0101 expected the name of a parameter before `:`",
             "1:32 J0101 what stands before `(` cannot be called", "1:40 J0101 expected `]` after the index, found `,`",
             "1:50 J0101 expected a dimension: a number, a dimension parameter, or a sum such as `i-2`",
             "1:69 J0101 expected a dimension: a number, a dimension parameter, or a sum such as `i-2`"}));
  EXPECT_EQ(of("mean(x for y in z, 3);"),
            (Lines{"1:25 J0101 a comprehension must be the only argument of an aggregate"}));
  EXPECT_EQ(of("apply_all f on face(a);"), (Lines{"1:30 J0101 expected the call of a rule after `apply_all`"}));
  EXPECT_EQ(of("if a { } else { } else if b { }"),
            (Lines{"1:38 J0101 this `else` comes after the last branch of the `if`"}));
}

TEST(ParseErrors, missing_semicolon_has_a_fix) {
  auto const parsed = parse("rule r on S { left { a <0>\n } right { a { p = b c; } } }");
  auto const sorted = parsed.diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 2U);
  ASSERT_EQ(sorted[0].fixits.size(), 1U);
  EXPECT_EQ(sorted[0].fixits[0].replacement, ";");
  EXPECT_EQ(sorted[0].fixits[0].span, (source::Span{0, 26, 26}));
  EXPECT_TRUE(sorted[1].fixits.empty());  // `b c` may lack an operator instead
}

TEST(ParseErrors, signs_of_formulas_have_a_fix) {
  auto const parsed = parse("rule r on S { left { require a − b “; } right { } }");
  auto const sorted = parsed.diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 2U);
  EXPECT_EQ(sorted[0].fixits.at(0).replacement, "-");
  EXPECT_EQ(parsed.sources.text(sorted[0].fixits.at(0).span), "−");
  EXPECT_EQ(sorted[1].fixits.at(0).replacement, "\"");
}

// ---- Recovery ----

TEST(ParseRecovery, every_broken_item_is_reported_and_the_others_stay) {
  auto const parsed = parse(R"(modeler M on gmap(2);
rule one on M { left { hook a <0; } right { a; } }
rule two on M {
  left { hook a <0>;
  right { a; }
}
rule three on M { left { hook a <0>; } right { a; } }
rule four on M { left { hook a <0>; } } right { a; } }
import )");
  EXPECT_EQ(errors(parsed),
            (Lines{"2:33 J0101 expected `,` or `>` after `0`, found `;`", "3:15 J0101 this `{` is not closed",
                   "8:39 J0101 expected `right`, found `}`",
                   "9:7 J0101 expected the name of a module after `import`, found the end of the file"}));
  ASSERT_EQ(parsed.file.items.size(), 2U);
  EXPECT_EQ(rule(parsed, 1).name.text, "three");
}

TEST(ParseRecovery, several_errors_of_one_item) {
  EXPECT_EQ(
      errors_of("rule r on S {\n left { hook a <0; b; c -0-; }\n right { a { p = 1 +; q = 2; } d 3; }\n}"),
      (Lines{"2:18 J0101 expected `,` or `>` after `0`, found `;`", "2:28 J0101 expected a name after `-`, found `;`",
             "3:21 J0101 expected an expression after `+`, found `;`",
             "3:34 J0101 expected `;` after the node `d`, found `3`"}));
}

TEST(ParseRecovery, errors_are_counted_out) {
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "rule;\n";
  auto const lines = errors_of(many);
  ASSERT_EQ(lines.size(), 1001U);
  EXPECT_EQ(lines.back(), "1001:1 J0101 more than 1000 errors; the rest of the file is not read");
}

// ---- Depth ----

std::string repeated(std::string const& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

std::string nested(std::string const& open, std::string const& inner, std::string const& close, int count) {
  return "rule r on S { left { require " + repeated(open, count) + inner + repeated(close, count) + "; } right { } }";
}

std::string operation(std::string const& body) { return "operation o on S { " + body + " }"; }

TEST(ParseDepth, up_to_the_limit) {
  constexpr int inside_two_braces = 254;
  EXPECT_EQ(errors_of(nested("(", "x", ")", inside_two_braces)), Lines{});
  EXPECT_EQ(errors_of(nested("f(", "x", ")", inside_two_braces)), Lines{});
  EXPECT_EQ(errors_of(nested("a[", "x", "]", inside_two_braces)), Lines{});
  EXPECT_EQ(errors_of(nested("<0>(", "x", ")", inside_two_braces)), Lines{});
  EXPECT_EQ(errors_of(nested("m(", "x", " for f in <0>(a))", inside_two_braces - 1)), Lines{});
  EXPECT_EQ(errors_of(nested("if ", "x", " then a else b", inside_two_braces)), Lines{});
  EXPECT_EQ(errors_of(nested("if a then b else ", "x", "", 500)), Lines{});
  EXPECT_EQ(errors_of(nested("a + ", "x", "", 500)), Lines{});
  EXPECT_EQ(errors_of(operation(repeated("while x { ", 255) + repeated("}", 255))), Lines{});
  EXPECT_EQ(errors_of(operation(repeated("try { ", 255) + repeated("} else { }", 255))), Lines{});
  EXPECT_EQ(errors_of(operation("if x { }" + repeated(" else if x { }", 256))), Lines{});
}

TEST(ParseDepth, past_the_limit) {
  EXPECT_EQ(errors_of(nested("(", "x", ")", 255)), (Lines{"1:284 J0103 more than 256 brackets are open here"}));
  EXPECT_EQ(errors_of(nested("if ", "x", " then a else b", 255)),
            (Lines{"1:792 J0103 more than 256 brackets and `if`s are open here"}));
  for (auto const* chain : {"- ", "not ", "a + ", "a * ", "a or ", "if a then b else "}) {
    auto const lines = errors_of(nested(chain, "x", "", 5000));
    ASSERT_EQ(lines.size(), 1U) << chain;
    EXPECT_NE(lines[0].find("J0103 more than 512 operations within each other in one expression"), std::string::npos)
        << lines[0];
  }
  EXPECT_EQ(errors_of(nested("", "x", ".y", 5000)).size(), 1U);
  EXPECT_EQ(errors_of(operation(repeated("while x { ", 256) + repeated("}", 256))).size(), 1U);
  EXPECT_EQ(errors_of(operation("if x { }" + repeated(" else if x { }", 5000))),
            (Lines{"1:3613 J0103 more than 256 branches in one `if`"}));
}

TEST(ParseDepth, megabytes_of_brackets) {
  EXPECT_EQ(errors_of(std::string(10'000'000, '(')), (Lines{"1:1 J0101 expected an item, found `(`"}));
  EXPECT_EQ(errors_of("rule " + std::string(1'000'000, '(') + "\nrule r on S { left { } right { } }"),
            (Lines{"1:262 J0103 more than 256 brackets are open here"}));
}

// ---- Garbage ----

/// Whatever the text, parse() returns, its spans lie in the file, and an item is missing only if an error says why.
void survives(std::string const& text) {
  auto const parsed = parse(text);
  for (auto const& diagnostic : parsed.diagnostics.all()) {
    EXPECT_LE(diagnostic.span.begin, diagnostic.span.end) << text;
    EXPECT_LE(diagnostic.span.end, text.size()) << text;
    EXPECT_FALSE(diagnostic.message.empty());
  }
  EXPECT_TRUE(!parsed.file.items.empty() || parsed.diagnostics.has_errors()) << text;
}

TEST(ParseGarbage, every_prefix) {
  for (std::size_t length = 0; length <= tests::everything_example.size(); ++length) {
    survives(std::string(tests::everything_example.substr(0, length)));
  }
}

TEST(ParseGarbage, random_bytes) {
  tests::Random random(1);
  for (int round = 0; round < 300; ++round) {
    std::string bytes;
    std::string characters = "rule r on S { ";
    for (int i = 0; i < 200; ++i) {
      bytes += static_cast<char>(random.below(256));
      characters += static_cast<char>(' ' + random.below(95));
    }
    survives(bytes);
    survives(characters);
  }
}

TEST(ParseGarbage, random_edits) {
  tests::Random random(1);
  for (int round = 0; round < 400; ++round) {
    std::string text(tests::everything_example);
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
      auto const at = random.below(text.size());
      if (random.below(2) == 0) {
        text.erase(at, 1 + random.below(8));
      } else {
        text.insert(at, std::string(tests::everything_example.substr(random.below(1000), 1 + random.below(8))));
      }
    }
    survives(text);
  }
}

}  // namespace
}  // namespace jrule

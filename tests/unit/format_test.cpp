#include "compiler/syntax/format.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/unit/parsed.h"
#include "tests/unit/syntax_examples.h"

namespace jrule {
namespace {

using syntax::format;

std::string dump(std::string text) {
  auto const parsed = tests::parse(std::move(text));
  EXPECT_EQ(tests::errors(parsed), tests::Lines{});
  return syntax::dump(parsed.file);
}

/// The two laws of the layout.
void obeys_laws(std::string const& text) {
  auto const once = format(text);
  EXPECT_EQ(format(once), once);
  EXPECT_EQ(dump(once), dump(text));
}

TEST(Format, canonical_texts_stay) {
  EXPECT_EQ(format(tests::surface_example), tests::surface_example);
  EXPECT_EQ(format(tests::halfedges_example), tests::halfedges_example);
  EXPECT_EQ(format(tests::models_example), tests::models_example);
}

TEST(Format, everything) {
  auto const once = format(tests::everything_example);
  obeys_laws(std::string(tests::everything_example));
  EXPECT_NE(once.find("    require a.x < -1 and not b.y == 2 or c.z;\n"), std::string::npos) << once;
  EXPECT_NE(once.find("    let q = a@~1.pos + a@[0,1].pos * -a@0.pos - r.c[d] / a@i.pos;\n"), std::string::npos)
      << once;
  EXPECT_NE(once.find("    t <-d[w]- s <-2- r;\n"), std::string::npos) << once;
}

TEST(Format, spaces_within_a_line) {
  EXPECT_EQ(format("import  std . surface ;"), "import std.surface;\n");
  EXPECT_EQ(format("model m( n ){dimensions 0 .. n;exchange( 0 , 2 ),(1,3);exchange(i,j)where i+2<=j;closed;}"),
            "model m(n) { dimensions 0..n; exchange (0,2), (1,3); exchange (i, j) where i + 2 <= j; closed; }\n");
  EXPECT_EQ(format("rule f [ i,j ]( x :Real=-1.0 ,y:[ Int ])on gmap( n-1 ){left{hook a< 0 .. i - 2 , _ >;}right{a;}}"),
            "rule f[i, j](x: Real = -1.0, y: [Int]) on gmap(n-1) { left  { hook a <0..i-2,_>; } right { a; } }\n");
  EXPECT_EQ(format("operation o on S->Dart{a -b ;sew [ i - 2 ]( a ,b ) ;x=not(a)and face ( a )by< 0 > ;f( n :- 1 );}"),
            "operation o on S -> Dart { a - b; sew[i-2](a, b); x = not (a) and face(a) by <0>; f(n: -1); }\n");
  EXPECT_EQ(
      format(
          "rule r on S{\nleft{}right{a- 0 -b;a -(i - 1)[ ~ 1 , 2 ]->b;a< - 2 [w] - b;b{p=a @ ~ 1 . q @ [ 1 ] ;} ;}}"),
      "rule r on S {\n"
      "  left  { } right { a -0- b; a -(i-1)[~1,2]-> b; a <-2[w]- b; b { p = a@~1.q@[1]; }; }\n"
      "}\n");
}

TEST(Format, lines_are_the_author_s) {
  EXPECT_EQ(format("\n\n\nmodeler M on gmap(2);import a;\n\n\n\nrule r on M { left { hook a <0>;\n\n\n b;   c; }\n\n "
                   "right {\n\n a; } }\n\n"),
            R"(modeler M on gmap(2);
import a;

rule r on M {
  left  {
    hook a <0>;

    b;  c;
  }

  right {
    a;
  }
}
)");
}

TEST(Format, long_lines) {
  // A block of one line that is too wide is split; so is a line of statements, where it is full.
  std::string const wide =
      "rule r on S {\n  left { hook abcdefghijklmnopqrstuvwxyz <0,1,2,3,4,5>; require abcdefghijklmnopqrstuvwxyz > "
      "abcdefghijklmnopqrstuvwxyz; }\n  right {\n    abcdefghijklmnopqrstuvwxyz; abcdefghijklmnopqrstuvwxyz "
      "-0- b; abcdefghijklmnopqrstuvwxyz -1- b; c -2- d; e -3- f;\n  }\n}\n";
  EXPECT_EQ(format(wide), R"(rule r on S {
  left  {
    hook abcdefghijklmnopqrstuvwxyz <0,1,2,3,4,5>;
    require abcdefghijklmnopqrstuvwxyz > abcdefghijklmnopqrstuvwxyz;
  }
  right {
    abcdefghijklmnopqrstuvwxyz; abcdefghijklmnopqrstuvwxyz -0- b; abcdefghijklmnopqrstuvwxyz -1- b;
    c -2- d; e -3- f;
  }
}
)");
  obeys_laws(wide);
}

TEST(Format, statements_of_several_lines) {
  EXPECT_EQ(format("operation o on S {\n  let x = a +\n b;\n}"), "operation o on S {\n  let x = a + b;\n}\n");
  std::string const sum =
      "operation o on S {\n  let a_long_name = another_long_name_of_a_value * a_factor +\nanother_long_name * "
      "another_factor_with_a_name;\n}\n";
  EXPECT_EQ(
      format(sum),
      "operation o on S {\n  let a_long_name = another_long_name_of_a_value * a_factor +\n      another_long_name * "
      "another_factor_with_a_name;\n}\n");
  obeys_laws(sum);
}

TEST(Format, comments) {
  std::string const text = R"(// head   
/* a
   b */
rule r on S { // opens

  // first
  left { hook a /* in */ <0>; /* behind */ } // ends
  right { /* alone */
    a; // one

    // two


    /// doc
    b // middle
      <1>; c;
    // last

  }
  // really
}   // after

// end)";
  EXPECT_EQ(format(text), R"(// head
/* a
   b */
rule r on S {  // opens

  // first
  left  { hook a /* in */ <0>; /* behind */ }  // ends
  right { /* alone */
    a;  // one

    // two

    /// doc
    b  // middle
        <1>; c;
    // last
  }
  // really
}  // after

// end
)");
  obeys_laws(text);
}

TEST(Format, colons_of_embeddings_line_up) {
  EXPECT_EQ(
      format("modeler M on gmap(2) {\n  embedding a: <0> -> T;\n  embedding abc :vertex->[T] {\n default 1; }\n}"),
      R"(modeler M on gmap(2) {
  embedding a   : <0> -> T;
  embedding abc : vertex -> [T] {
    default 1;
  }
}
)");
  EXPECT_EQ(format("modeler M on gmap(2) { embedding a: <0> -> T; embedding abc :vertex->[T]; }"),
            "modeler M on gmap(2) { embedding a : <0> -> T; embedding abc : vertex -> [T]; }\n");
}

TEST(Format, line_ends_and_byte_order_mark) {
  EXPECT_EQ(format("\xEF\xBB\xBFimport a;\r\n\r\n// é\r\nimport b;\rimport c;"),
            "import a;\n\n// é\nimport b;\nimport c;\n");
  EXPECT_EQ(format("// only\n"), "// only\n");
  EXPECT_EQ(format(""), "");
}

TEST(Format, what_does_not_parse_is_left_alone) {
  for (std::string const text : {"rule  r", "  ;", "import a; \xFF", "import  a; /* b", "rule r on S { left  { a"}) {
    EXPECT_EQ(format(text), text);
  }
}

// ---- The laws, for texts with the white space of chance ----

/// White space of a text becomes other white space, now and then a comment.
std::string shaken(std::string_view text, tests::Random& random) {
  static constexpr std::string_view gaps[] = {" ",    "  ",      "\n",       "\n\n",      "\n\n\n",
                                              " \t ", " // c\n", "\n// c\n", " /* c */ ", "\n/* c\n  d */\n"};
  std::string result;
  bool in_comment = false;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char const c = text[i];
    if (!in_string && text.substr(i).starts_with("//")) in_comment = true;
    if (!in_comment && c == '"' && text[i - 1] != '\\') in_string = !in_string;
    if (in_comment && c == '\n') {
      in_comment = false;
      result += '\n';
    } else if (!in_comment && !in_string && (c == ' ' || c == '\n')) {
      if (result.empty() || (result.back() != ' ' && result.back() != '\n'))
        result += gaps[random.below(random.below(2) == 0 ? 3 : 10)];
    } else {
      result += c;
    }
  }
  return result;
}

TEST(Format, laws_hold_for_any_white_space) {
  for (std::uint64_t seed = 0; seed < 60 && !testing::Test::HasFailure(); ++seed) {
    tests::Random random(seed);
    for (auto text :
         {tests::surface_example, tests::halfedges_example, tests::models_example, tests::everything_example}) {
      auto const other = shaken(text, random);
      SCOPED_TRACE(other);
      obeys_laws(other);
    }
  }
}

}  // namespace
}  // namespace jrule

#include "compiler/source/diagnostic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace jrule::source {
namespace {

/// One file, and spans given by the text they cover.
class OneFile {
 public:
  explicit OneFile(std::string text, std::string path = "a.jrule") { sources.add(std::move(path), std::move(text)); }

  Span at(std::string_view words, std::size_t nth = 1) const {
    auto const& text = sources.file(0).text;
    auto begin = text.find(words);
    for (; nth > 1; --nth) begin = text.find(words, begin + 1);
    if (begin == std::string::npos) throw std::invalid_argument("no such text");
    return {0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + words.size())};
  }
  std::string human(Diagnostic const& diagnostic) const { return render_human(sources, diagnostic); }

  Sources sources;
};

Diagnostic problem(Span span, std::string message = "something is wrong") {
  return {.code = Code::syntax_error, .span = span, .message = std::move(message)};
}

// -------------------------------------------------------------------------------------------------------------- codes

TEST(Codes, are_in_order_and_their_numbers_unique) {
  std::set<std::string_view> numbers;
  for (std::size_t i = 0; i < all_codes().size(); ++i) {
    auto const& code = all_codes()[i];
    EXPECT_EQ(static_cast<std::size_t>(code.code), i);
    EXPECT_EQ(code.number.size(), 5U) << code.number;
    EXPECT_EQ(code.number.find_first_not_of("0123456789", 1), std::string_view::npos) << code.number;
    EXPECT_TRUE(numbers.insert(code.number).second) << code.number << " twice";
    EXPECT_TRUE(i == 0 || all_codes()[i - 1].number < code.number) << code.number << " is out of order";
    EXPECT_EQ(&info(code.code), &code);
  }
}

TEST(Codes, are_found_by_number) {
  ASSERT_NE(find_code("J0101"), nullptr);
  EXPECT_EQ(find_code("J0101")->code, Code::syntax_error);
  EXPECT_EQ(find_code("j0101"), find_code("J0101"));
  EXPECT_EQ(find_code("J010"), nullptr);
  EXPECT_EQ(find_code("J01011"), nullptr);
  EXPECT_EQ(find_code(""), nullptr);
  EXPECT_EQ(info(Code::syntax_error).name, "syntax_error");
}

TEST(Codes, have_their_own_page) {
  EXPECT_TRUE(explanation(Code::syntax_error).starts_with("# J0101: "));
  EXPECT_TRUE(explanation(Code::cannot_read_file).starts_with("# J0001: "));
}

// -------------------------------------------------------------------------------------------------------- the
// collection

TEST(Diagnostics, counts_errors) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.has_errors());
  std::size_t errors = 0;
  for (auto const& code : all_codes()) {
    diagnostics.add({.code = code.code, .span = {}, .message = ""});
    errors += code.severity == Severity::error ? 1 : 0;
  }
  EXPECT_EQ(diagnostics.error_count(), errors);
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Diagnostics, are_sorted_by_place_and_stable) {
  Diagnostics diagnostics;
  diagnostics.add(problem({1, 5, 6}, "f"));
  diagnostics.add(problem({0, 9, 10}, "e"));
  diagnostics.add(problem({0, 5, 9}, "c"));
  diagnostics.add(problem({0, 5, 6}, "d"));
  diagnostics.add(problem({0, 1, 2}, "b"));
  diagnostics.add(problem({}, "a"));
  std::string order;
  for (auto const& d : diagnostics.sorted()) order += d.message;
  EXPECT_EQ(order, "abcdef");
}

TEST(Diagnostics, exact_repetitions_come_once) {
  Diagnostics diagnostics;
  auto const add = [&](std::string const& message, std::string const& label) {
    auto d = problem({0, 5, 6}, message);
    d.labels.push_back({{0, 1, 2}, label});
    diagnostics.add(d);
  };
  add("x", "one");
  add("y", "one");
  add("x", "one");  // not beside the first
  add("x", "two");
  EXPECT_EQ(diagnostics.all().size(), 4U);
  EXPECT_EQ(diagnostics.sorted().size(), 3U);
}

// ------------------------------------------------------------------------------------------------------ for people

TEST(Human, a_span_on_a_line) {
  OneFile const f("rule a on M {\n  left { hook a <0>; }\n}\n");
  EXPECT_EQ(f.human(problem(f.at("hook"), "no hook here")),
            "a.jrule:2:10: error: no hook here [J0101]\n"
            "2 |   left { hook a <0>; }\n"
            "  |          ^^^^\n");
}

TEST(Human, the_label_at_the_place_of_the_problem_stands_beside_the_carets) {
  OneFile const f("a -0- b;");
  auto d = problem(f.at("-0-"));
  d.labels = {{f.at("-0-"), "this arc"}};
  EXPECT_EQ(f.human(d),
            "a.jrule:1:3: error: something is wrong [J0101]\n"
            "1 | a -0- b;\n"
            "  |   ^^^ this arc\n");
}

TEST(Human, labels_notes_and_fixits) {
  std::string text = "rule q on S {\n  left { hook a <0,1>; }\n  right {\n";
  for (int i = 4; i <= 9; ++i) text += "\n";
  OneFile const f(text + "    a; c <_,1>;\n    a -0- c; a -0- c;\n  }\n}\n");
  auto d = problem(f.at("a -0- c", 2), "this arc is written twice");
  d.labels = {
      {f.at("a -0- c"), "first written here"}, {f.at("c <_,1>"), "this node is added"}, {f.at("a <0,1>"), "the hook"}};
  d.notes = {"an arc is written once (language.md)", "as in the map\n  0 -- 1\n\nof two darts"};
  d.fixits = {{f.at("a -0- c;", 2), "", "remove the second arc"},
              {f.at("<_,1>"), "<_,2>", "relabel"},
              {{0, f.at("c <_,1>").begin, f.at("c <_,1>").begin}, "b;\n   ", ""}};
  EXPECT_EQ(f.human(d),
            "a.jrule:11:14: error: this arc is written twice [J0101]\n"
            " 2 |   left { hook a <0,1>; }\n"
            "   |               ------- the hook\n"
            "...\n"
            "10 |     a; c <_,1>;\n"
            "   |        ------- this node is added\n"
            "11 |     a -0- c; a -0- c;\n"
            "   |     ------- first written here\n"
            "   |              ^^^^^^^\n"
            "   = note: an arc is written once (language.md)\n"
            "   = note: as in the map\n"
            "             0 -- 1\n"
            "\n"
            "           of two darts\n"
            "   = help: remove the second arc: remove `a -0- c;` at 11:14\n"
            "   = help: relabel: replace `<_,1>` with `<_,2>` at 10:10\n"
            "   = help: insert `b;` at 10:8\n");
}

TEST(Human, a_place_between_characters) {
  OneFile const f("a -0- b\nc;");
  EXPECT_EQ(f.human(problem({0, 7, 7}, "`;` is missing")),
            "a.jrule:1:8: error: `;` is missing [J0101]\n"
            "1 | a -0- b\n"
            "  |        ^\n");
}

TEST(Human, the_end_of_the_file) {
  OneFile const f("rule {\n");
  EXPECT_EQ(f.human(problem({0, 7, 7}, "`}` is missing")),
            "a.jrule:2:1: error: `}` is missing [J0101]\n"
            "2 |\n"
            "  | ^\n");
}

TEST(Human, a_span_outside_the_file_is_its_end) {
  OneFile const f("ab");
  EXPECT_EQ(f.human(problem({0, 70, 90})), f.human(problem({0, 2, 2})));
  EXPECT_EQ(f.human(problem({0, 1, 90})), f.human(problem({0, 1, 2})));
}

TEST(Human, a_span_over_lines_is_marked_to_the_end_of_its_first) {
  OneFile const f("x; rule q {\r\n  left {}\r\n}\r\n");
  EXPECT_EQ(f.human(problem({0, 3, 24})),
            "a.jrule:1:4: error: something is wrong [J0101]\n"
            "1 | x; rule q {\n"
            "  |    ^^^^^^^^\n");
}

TEST(Human, tabs_and_letters_beyond_ascii) {
  OneFile const f("\té\tx");
  EXPECT_EQ(f.human(problem(f.at("x"))),
            "a.jrule:1:4: error: something is wrong [J0101]\n"
            "1 |         é       x\n"
            "  |                 ^\n");
  EXPECT_EQ(f.human(problem(f.at("\t"))),
            "a.jrule:1:1: error: something is wrong [J0101]\n"
            "1 |         é       x\n"
            "  | ^^^^^^^^\n");
}

TEST(Human, bytes_that_are_not_text) {
  OneFile const f("a\xFF\x1B b", "a\n.jrule");
  EXPECT_EQ(f.human(problem(f.at("b"), "bad\x1B[2J")),
            "a<0A>.jrule:1:5: error: bad<1B>[2J [J0101]\n"
            "1 | a<FF><1B> b\n"
            "  |           ^\n");
}

TEST(Human, a_long_line_is_cut_around_the_span) {
  OneFile const f(std::string(500, 'x') + "HERE" + std::string(500, 'y'));
  EXPECT_EQ(f.human(problem(f.at("HERE"))),
            "a.jrule:1:501: error: something is wrong [J0101]\n"
            "1 | …" +
                std::string(97, 'x') + "HERE" + std::string(97, 'y') +
                "…\n"
                "  | " +
                std::string(98, ' ') + "^^^^\n");
}

TEST(Human, a_long_line_keeps_its_begin_or_end_if_the_span_is_there) {
  OneFile const begin("HERE" + std::string(500, 'y'));
  EXPECT_EQ(begin.human(problem(begin.at("HERE"))),
            "a.jrule:1:1: error: something is wrong [J0101]\n"
            "1 | HERE" +
                std::string(195, 'y') +
                "…\n"
                "  | ^^^^\n");
  OneFile const end(std::string(500, 'x') + "HERE");
  EXPECT_EQ(end.human(problem(end.at("HERE"))),
            "a.jrule:1:501: error: something is wrong [J0101]\n"
            "1 | …" +
                std::string(195, 'x') +
                "HERE\n"
                "  | " +
                std::string(196, ' ') + "^^^^\n");
  EXPECT_EQ(end.human(problem({0, 504, 504})),
            "a.jrule:1:505: error: something is wrong [J0101]\n"
            "1 | …" +
                std::string(195, 'x') +
                "HERE\n"
                "  | " +
                std::string(200, ' ') + "^\n");
}

TEST(Human, a_label_that_a_cut_line_does_not_show_is_marked_at_the_cut) {
  OneFile const f("FIRST" + std::string(500, 'x') + "HERE" + std::string(500, 'y') + "LAST");
  auto d = problem(f.at("HERE"));
  d.labels = {{f.at("FIRST"), "one"}, {f.at("LAST"), "two"}};
  EXPECT_EQ(f.human(d),
            "a.jrule:1:506: error: something is wrong [J0101]\n"
            "1 | …" +
                std::string(97, 'x') + "HERE" + std::string(97, 'y') +
                "…\n"
                "  | - one\n"
                "  | " +
                std::string(98, ' ') +
                "^^^^\n"
                "  | " +
                std::string(199, ' ') + "- two\n");
}

TEST(Human, a_span_longer_than_the_window) {
  OneFile const f(std::string(50, 'x') + std::string(1000, 'H'));
  EXPECT_EQ(f.human(problem({0, 50, 1050})),
            "a.jrule:1:51: error: something is wrong [J0101]\n"
            "1 | …" +
                std::string(19, 'x') + std::string(179, 'H') +
                "…\n"
                "  | " +
                std::string(20, ' ') + std::string(180, '^') + "\n");
}

TEST(Human, a_problem_without_a_place) {
  OneFile const f("text");
  auto d = problem({}, "no input");
  d.notes = {"a note"};
  d.labels = {{{}, "nowhere"}};
  d.fixits = {{{}, "jrule check a.jrule", "give a file"}};
  EXPECT_EQ(f.human(d),
            "jrule: error: no input [J0101]\n"
            "  = note: nowhere\n"
            "  = note: a note\n"
            "  = help: give a file: write `jrule check a.jrule`\n");
}

TEST(Human, a_file_without_text_has_no_lines) {
  OneFile const f("");
  EXPECT_EQ(f.human(problem({0, 0, 0}, "cannot be read")), "a.jrule: error: cannot be read [J0101]\n");
}

TEST(Human, a_file_that_does_not_exist_is_no_place) {
  EXPECT_EQ(render_human(Sources{}, problem({7, 0, 0})), "jrule: error: something is wrong [J0101]\n");
}

TEST(Human, labels_in_other_files_come_after) {
  Sources sources;
  sources.add("first.jrule", "rule a\n");
  sources.add("second.jrule", "\nrule a\n");
  auto d = problem({1, 6, 7}, "`a` is declared twice");
  d.labels = {{{0, 5, 6}, "also here"}};
  d.fixits = {{{0, 5, 6}, "b", ""}};
  EXPECT_EQ(render_human(sources, d),
            "second.jrule:2:6: error: `a` is declared twice [J0101]\n"
            "2 | rule a\n"
            "  |      ^\n"
            "  ::: first.jrule:1:6\n"
            "1 | rule a\n"
            "  |      - also here\n"
            "  = help: replace `a` with `b` at first.jrule:1:6\n");
}

TEST(Human, a_long_replacement_is_shortened) {
  OneFile const f("x");
  auto d = problem(f.at("x"));
  d.fixits = {{f.at("x"), std::string(100, 'r'), ""}};
  EXPECT_NE(f.human(d).find("replace `x` with `" + std::string(59, 'r') + "…` at 1:1\n"), std::string::npos);
}

/// The text without the terminal's colour sequences.
std::string plain(std::string_view colored) {
  std::string result;
  while (!colored.empty()) {
    if (colored.starts_with("\033[")) {
      colored.remove_prefix(colored.find('m') + 1);
    } else {
      result += colored.front();
      colored.remove_prefix(1);
    }
  }
  return result;
}

TEST(Human, colour_adds_nothing_but_colour) {
  OneFile const f("a -0- b;\n\nc;");
  auto d = problem(f.at("c"));
  d.labels = {{f.at("-0-"), "label"}};
  d.notes = {"note"};
  auto const colored = render_human(f.sources, d, {.color = true});
  EXPECT_NE(colored.find("\033[1;31merror:\033[0m"), std::string::npos);
  EXPECT_EQ(plain(colored), f.human(d));
  EXPECT_EQ(f.human(d).find('\033'), std::string::npos);
}

// ------------------------------------------------------------------------------------------------------ for programs

TEST(Json, has_its_keys_in_order_on_one_line) {
  OneFile const f("é -0- b;\nc;");
  auto d = problem(f.at("-0-"), "a \"quoted\"\nmessage");
  d.notes = {"one", "two"};
  d.labels = {{f.at("c"), "here"}};
  d.fixits = {{f.at("c"), "d", "rename"}};
  EXPECT_EQ(render_json(f.sources, d),
            R"({"schema":1,"code":"J0101","severity":"error","message":"a \"quoted\"\nmessage","file":"a.jrule",)"
            R"("line":1,"column":3,"endLine":1,"endColumn":6,"notes":["one","two"],)"
            R"("labels":[{"message":"here","file":"a.jrule","line":2,"column":1,"endLine":2,"endColumn":2}],)"
            R"("fixits":[{"message":"rename","replacement":"d","file":"a.jrule","line":2,"column":1,)"
            R"("endLine":2,"endColumn":2}]})"
            "\n");
}

TEST(Json, can_be_read_back) {
  OneFile const f("a\n-0-\nb;");
  auto const read = nlohmann::json::parse(render_json(f.sources, problem({0, 2, 7}, "∀ \x1B")));
  EXPECT_EQ(read.at("message"), "∀ \x1B");
  EXPECT_EQ(read.at("line"), 2);
  EXPECT_EQ(read.at("endLine"), 3);
  EXPECT_EQ(read.at("endColumn"), 2);
  EXPECT_EQ(read.at("labels"), nlohmann::json::array());
  EXPECT_EQ(read.at("fixits"), nlohmann::json::array());
  EXPECT_EQ(read.at("notes"), nlohmann::json::array());
}

TEST(Json, places_that_do_not_exist_are_null) {
  OneFile const f("");
  auto const nowhere = nlohmann::json::parse(render_json(f.sources, problem({})));
  EXPECT_TRUE(nowhere.at("file").is_null());
  EXPECT_TRUE(nowhere.at("line").is_null());
  EXPECT_TRUE(nowhere.at("endColumn").is_null());
  auto const no_text = nlohmann::json::parse(render_json(f.sources, problem({0, 0, 0})));
  EXPECT_EQ(no_text.at("file"), "a.jrule");
  EXPECT_TRUE(no_text.at("line").is_null());
}

TEST(Json, text_that_is_not_utf8_does_not_make_it_fail) {
  OneFile const f("x", "\xFF.jrule");
  auto const read = nlohmann::json::parse(render_json(f.sources, problem(f.at("x"), "\xC3")));
  EXPECT_EQ(read.at("file"), "\xEF\xBF\xBD.jrule");
}

}  // namespace
}  // namespace jrule::source

#include "compiler/source/source.h"

#include <gtest/gtest.h>

#include "compiler/source/glyph.h"

namespace jrule::source {
namespace {

/// Line and column of a place in a text that is the only file.
std::pair<std::size_t, std::size_t> place(std::string const& text, std::size_t offset) {
  Sources sources;
  auto const file = sources.add("a.jrule", text);
  auto const at = sources.position(file, static_cast<std::uint32_t>(offset));
  return {at.line, at.column};
}

using Place = std::pair<std::size_t, std::size_t>;

TEST(Position, starts_at_one) {
  EXPECT_EQ(place("abc", 0), Place(1, 1));
  EXPECT_EQ(place("abc", 2), Place(1, 3));
}

TEST(Position, the_end_of_the_text_is_a_place) {
  EXPECT_EQ(place("abc", 3), Place(1, 4));
  EXPECT_EQ(place("abc\n", 4), Place(2, 1));
  EXPECT_EQ(place("", 0), Place(1, 1));
}

TEST(Position, past_the_end_is_the_end) { EXPECT_EQ(place("ab\nc", 99), Place(2, 2)); }

TEST(Position, a_line_end_belongs_to_its_line) {
  EXPECT_EQ(place("ab\ncd", 2), Place(1, 3));
  EXPECT_EQ(place("ab\ncd", 3), Place(2, 1));
  EXPECT_EQ(place("\n\n\n", 2), Place(3, 1));
}

TEST(Position, counts_a_tab_as_one) { EXPECT_EQ(place("\t\ta", 2), Place(1, 3)); }

TEST(Position, counts_code_points) {
  EXPECT_EQ(place("é<", 2), Place(1, 2));
  EXPECT_EQ(place("// ∀😀 x", 3 + 3 + 4 + 1), Place(1, 7));
}

TEST(Position, windows_line_ends) {
  EXPECT_EQ(place("ab\r\ncd", 4), Place(2, 1));
  EXPECT_EQ(place("ab\r\ncd", 5), Place(2, 2));
}

TEST(Position, a_lone_carriage_return_ends_no_line) { EXPECT_EQ(place("a\rb", 2), Place(1, 3)); }

TEST(Sources, offsets_do_not_count_a_byte_order_mark) {
  Sources sources;
  auto const file = sources.add("a.jrule", "\xEF\xBB\xBFrule");
  EXPECT_EQ(sources.file(file).text, "rule");
  EXPECT_EQ(sources.position(file, 0).column, 1U);
}

TEST(Sources, lines_come_without_their_ends) {
  Sources sources;
  auto const file = sources.add("a.jrule", "one\ntwo\r\n\nlast");
  EXPECT_EQ(sources.line(file, 1), "one");
  EXPECT_EQ(sources.line(file, 2), "two");
  EXPECT_EQ(sources.line(file, 3), "");
  EXPECT_EQ(sources.line(file, 4), "last");
  EXPECT_EQ(sources.line(file, 5), "");
  EXPECT_EQ(sources.line(file, 0), "");
}

TEST(Sources, text_of_a_span) {
  Sources sources;
  auto const file = sources.add("a.jrule", "abcdef");
  EXPECT_EQ(sources.text({file, 1, 3}), "bc");
  EXPECT_EQ(sources.text({file, 2, 2}), "");
  EXPECT_EQ(sources.text({file, 4, 99}), "ef");
  EXPECT_EQ(sources.text({file, 3, 1}), "");
  EXPECT_EQ(sources.text(Span{}), "");
}

TEST(Sources, a_file_stays_where_it_is) {
  Sources sources;
  auto const* first = &sources.file(sources.add("first", "text"));
  for (int i = 0; i < 1000; ++i) sources.add("more", "");
  EXPECT_EQ(first, &sources.file(0));
  EXPECT_EQ(sources.size(), 1001U);
}

TEST(Span, join_covers_both) { EXPECT_EQ(join({3, 5, 8}, {3, 20, 22}), (Span{3, 5, 22})); }

TEST(Glyph, a_tab_goes_to_the_next_multiple_of_8) {
  EXPECT_EQ(printable("\tx"), "        x");
  EXPECT_EQ(printable("abc\tx"), "abc     x");
  EXPECT_EQ(printable("12345678\tx"), "12345678        x");
  EXPECT_EQ(display_column("é\tx", 3), 8U);
}

TEST(Glyph, what_could_move_the_cursor_is_spelled_out) {
  EXPECT_EQ(printable("a\x1B[31m"), "a<1B>[31m");
  EXPECT_EQ(printable("a\xC2\x9B"), "a<9B>");
  EXPECT_EQ(printable("a\xE2\x80\xAE"), "a<U+202E>");
}

TEST(Glyph, invalid_utf8_is_spelled_out) {
  EXPECT_EQ(printable("\xFF"), "<FF>");
  EXPECT_EQ(printable("\xC3"), "<C3>");          // cut short
  EXPECT_EQ(printable("\xC0\x80"), "<C0><80>");  // overlong
  EXPECT_EQ(printable("\xE0\x80\x80"), "<E0><80><80>");
  EXPECT_EQ(printable("\xED\xA0\x80"), "<ED><A0><80>");  // a surrogate
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "<F4><90><80><80>");
  EXPECT_EQ(printable("\xC3\xA9\xE2\x88\x80\xF0\x9F\x98\x80"), "é∀😀");
}

TEST(Glyph, columns_may_cut_a_tab) {
  EXPECT_EQ(shown_columns("a\tb", 4, 9), "    b");
  EXPECT_EQ(shown_columns("é∀x", 1, 2), "∀");
}

}  // namespace
}  // namespace jrule::source

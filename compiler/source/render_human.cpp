// A diagnostic for people: a first line that editors and build logs know from GCC, then the source lines with their
// marks.
//
//   quad.jrule:7:5: error: the right side creates `c` without a 2-arc [J0302]
//   3 |   left { hook a <0,1>; }
//     |          ------------- copied from this hook
//   ...
//   7 |     c <_,1>;
//     |     ^
//     = note: in a 2-G-map every dart has exactly one 2-arc
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "compiler/source/glyph.h"
#include "compiler/source/place.h"

namespace jrule::source {

namespace {

constexpr std::size_t widest_line = 200;
constexpr std::size_t context = 20;  ///< columns kept before a mark that is itself too long
constexpr std::size_t longest_quote = 60;

// ------------------------------------------------------------------------------------------------------------ colour

/// Wraps text in terminal colours, or returns it as it is.
class Painter {
 public:
  Painter(HumanStyle style, Severity severity) : on_(style.color) {
    problem_ = severity == Severity::error ? "1;31" : severity == Severity::warning ? "1;35" : "1;36";
  }
  std::string bold(std::string_view text) const { return paint(text, "1"); }
  std::string frame(std::string_view text) const { return paint(text, "1;34"); }
  std::string problem(std::string_view text) const { return paint(text, problem_); }

 private:
  std::string paint(std::string_view text, std::string_view code) const {
    return on_ ? fmt::format("\033[{}m{}\033[0m", code, text) : std::string(text);
  }
  bool on_;
  std::string_view problem_;
};

// ------------------------------------------------------------------------------------------------------------- marks

/// An underlined part of one line.
struct Mark {
  FileId file = no_file;
  std::size_t line = 0;
  std::size_t begin = 0;  ///< display columns, 0-based; never empty, so that a place between characters shows too
  std::size_t end = 0;
  std::uint32_t offset = 0;
  bool primary = false;
  std::string text;
};

Mark mark(Sources const& sources, Span span, Position at, bool primary, std::string_view text) {
  auto const line = sources.line(span.file, at.line);
  auto const start = sources.file(span.file).line_starts[at.line - 1];
  auto const begin = display_column(line, span.begin - start);
  // Of a span over several lines the first is underlined, to its end.
  auto const end = display_column(line, std::max(span.begin, span.end) - start);
  return {span.file, at.line, begin, std::max(end, begin + 1), span.begin, primary, printable(text)};
}

/// All marks in the order they are shown: the file of the problem first, in each file by position.
std::vector<Mark> marks_of(Sources const& sources, Diagnostic const& diagnostic) {
  std::vector<Mark> marks;
  auto const add = [&](Span span, bool primary, std::string_view text) {
    auto const range = range_of(sources, span);
    if (!range) return;
    // A place past the end of the file is its end.
    auto const size = static_cast<std::uint32_t>(sources.file(span.file).text.size());
    Span const inside{span.file, std::min(span.begin, size), std::min(span.end, size)};
    marks.push_back(mark(sources, inside, range->begin, primary, text));
  };
  auto const& labels = diagnostic.labels;
  // A label at the place of the problem says something about it, and needs no second underline.
  auto const own =
      std::find_if(labels.begin(), labels.end(), [&](Label const& l) { return l.span == diagnostic.span; });
  add(diagnostic.span, true, own == labels.end() ? std::string_view{} : own->text);
  for (auto label = labels.begin(); label != labels.end(); ++label) {
    if (label != own) add(label->span, false, label->text);
  }
  auto const key = [&](Mark const& m) { return std::tuple(m.file != diagnostic.span.file, m.file, m.offset); };
  std::stable_sort(marks.begin(), marks.end(), [&](Mark const& a, Mark const& b) { return key(a) < key(b); });
  return marks;
}

// -------------------------------------------------------------------------------------------------------- source lines

/// The columns [begin, end) of a line of `width` columns that are shown.
struct Window {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t width = 0;
  bool cut_before() const { return begin > 0; }
  bool cut_after() const { return end < width; }
  /// The column in the window; those outside fall on the `…` at its ends.
  std::size_t place(std::size_t column) const { return std::clamp(column, begin, cut_after() ? end - 1 : end) - begin; }
};

/// A line that is too long is cut around its marks; if they are too far apart, around the problem itself.
Window window_around(std::vector<Mark> const& marks, std::size_t width) {
  if (width <= widest_line) return {0, width, width};
  auto begin = marks.front().begin;
  auto end = begin;
  for (auto const& m : marks) end = std::max(end, m.end);
  if (end - begin + 2 * context > widest_line) {
    auto const primary = std::find_if(marks.begin(), marks.end(), [](Mark const& m) { return m.primary; });
    auto const& focus = primary == marks.end() ? marks.front() : *primary;
    begin = focus.begin;
    end = focus.end;
  }
  auto const length = std::min(end - begin, widest_line);
  auto const before = std::max(context, (widest_line - length) / 2);
  auto const first = std::min(begin - std::min(begin, before), width - widest_line);
  return {first, first + widest_line, width};
}

std::string shown_line(std::string_view line, Window window) {
  auto text =
      shown_columns(line, window.begin + (window.cut_before() ? 1 : 0), window.end - (window.cut_after() ? 1 : 0));
  if (window.cut_before()) text.insert(0, "…");
  if (window.cut_after()) text += "…";
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

std::string underline(Mark const& m, Window window, Painter const& painter) {
  auto const begin = window.place(m.begin);
  auto const length = std::max<std::size_t>(1, window.place(m.end - 1) + 1 - begin);
  auto marked = std::string(length, m.primary ? '^' : '-');
  if (!m.text.empty()) marked += " " + m.text;
  return std::string(begin, ' ') + (m.primary ? painter.problem(marked) : painter.frame(marked));
}

/// The lines with marks, each once, with one row for each of its marks. A file other than the problem's is named.
std::string snippet(Sources const& sources, FileId file, std::vector<Mark> const& marks, std::size_t gutter,
                    Painter const& painter) {
  std::string out;
  std::size_t shown_line_number = 0;
  auto const row = [&](std::string_view number, std::string_view text) {
    auto const edge = painter.frame(fmt::format("{:>{}} |", number, gutter));
    out += text.empty() ? edge + "\n" : fmt::format("{} {}\n", edge, text);
  };
  for (auto first = marks.begin(); first != marks.end();) {
    auto const last =
        std::find_if(first, marks.end(), [&](Mark const& m) { return m.file != first->file || m.line != first->line; });
    bool const same_file = first->file == file;
    if (same_file && shown_line_number != 0 && shown_line_number + 1 < first->line) out += painter.frame("...") + "\n";
    if (!same_file) {
      auto const at = sources.position(first->file, first->offset);
      out += fmt::format("{} {}:{}:{}\n", painter.frame(std::string(gutter + 1, ' ') + ":::"),
                         printable(sources.file(first->file).path), at.line, at.column);
    }
    file = first->file;
    shown_line_number = first->line;
    auto const line = sources.line(first->file, first->line);
    auto const window = window_around({first, last}, display_column(line, line.size()));
    row(std::to_string(first->line), shown_line(line, window));
    for (; first != last; ++first) row("", underline(*first, window, painter));
  }
  return out;
}

// ------------------------------------------------------------------------------------------------- notes and fix-its

/// Code inside a sentence: white space of any kind as one blank, and not too long.
std::string quoted(std::string_view code) {
  std::string words;
  for (char c : code) {
    bool const blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank)
      words += c;
    else if (!words.empty() && !words.ends_with(' '))
      words += ' ';
  }
  if (words.ends_with(' ')) words.pop_back();
  auto const width = display_column(words, words.size());
  if (width <= longest_quote) return fmt::format("`{}`", printable(words));
  return fmt::format("`{}…`", shown_columns(words, 0, longest_quote - 1));
}

std::string described(Sources const& sources, FixIt const& fixit, Span problem) {
  auto text = fixit.text.empty() ? std::string{} : fixit.text + ": ";
  auto const range = range_of(sources, fixit.span);
  if (!range) return text + "write " + quoted(fixit.replacement);
  auto const old = sources.text(fixit.span);
  text += old.empty()                 ? "insert " + quoted(fixit.replacement)
          : fixit.replacement.empty() ? "remove " + quoted(old)
                                      : fmt::format("replace {} with {}", quoted(old), quoted(fixit.replacement));
  text += " at ";
  if (fixit.span.file != problem.file) text += sources.file(fixit.span.file).path + ":";
  return text + fmt::format("{}:{}", range->begin.line, range->begin.column);
}

/// `= note: text`; the further lines of a text stand below its first.
std::string remark(std::size_t gutter, std::string_view kind, std::string_view text, Painter const& painter) {
  auto const head = fmt::format("= {}: ", kind);
  std::string out = std::string(gutter + 1, ' ') + painter.frame(head.substr(0, 1)) + painter.bold(head.substr(1));
  for (std::size_t begin = 0; begin <= text.size();) {
    auto const end = std::min(text.find('\n', begin), text.size());
    if (begin > 0 && end > begin) out += std::string(gutter + 1 + head.size(), ' ');
    out += printable(text.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return out;
}

std::string first_line(Sources const& sources, Diagnostic const& diagnostic, Painter const& painter) {
  auto const& code = info(diagnostic.code);
  auto const* file = file_of(sources, diagnostic.span);
  std::string place = file == nullptr ? "jrule" : printable(file->path);
  if (auto const range = range_of(sources, diagnostic.span)) {
    place += fmt::format(":{}:{}", range->begin.line, range->begin.column);
  }
  return fmt::format("{} {} {}\n", painter.bold(place + ":"), painter.problem(fmt::format("{}:", word(severity(diagnostic)))),
                     painter.bold(fmt::format("{} [{}]", printable(diagnostic.message), code.number)));
}

}  // namespace

std::string render_human(Sources const& sources, Diagnostic const& diagnostic, HumanStyle style) {
  Painter const painter(style, severity(diagnostic));
  auto const marks = marks_of(sources, diagnostic);
  std::size_t last_line = 1;
  for (auto const& m : marks) last_line = std::max(last_line, m.line);
  auto const gutter = std::to_string(last_line).size();

  auto out = first_line(sources, diagnostic, painter) + snippet(sources, diagnostic.span.file, marks, gutter, painter);
  for (auto const& label : diagnostic.labels) {
    if (!range_of(sources, label.span)) out += remark(gutter, "note", label.text, painter);
  }
  for (auto const& note : diagnostic.notes) out += remark(gutter, "note", note, painter);
  for (auto const& fixit : diagnostic.fixits) {
    out += remark(gutter, "help", described(sources, fixit, diagnostic.span), painter);
  }
  return out;
}

}  // namespace jrule::source

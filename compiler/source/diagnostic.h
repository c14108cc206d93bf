// Diagnostics: what is wrong, where, in words for a geometer. Collected, sorted and rendered once; never printed on the way.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/source/source.h"

namespace jrule::source {

enum class Severity { error, warning, note };

/// One entry for each row of diagnostics.def, the only source of codes.
enum class Code {
#define JRULE_DIAGNOSTIC(number, name, severity, title) name,
#include "compiler/source/diagnostics.def"
#undef JRULE_DIAGNOSTIC
};

struct CodeInfo {
  Code code;
  std::string_view number;  ///< "J0302"
  std::string_view name;    ///< "missing_arc"
  Severity severity;
  std::string_view title;   ///< one line for lists
};
CodeInfo const& info(Code code);
std::vector<CodeInfo> const& all_codes();
/// The code with that number, upper or lower case; nullptr if there is none.
CodeInfo const* find_code(std::string_view number);
/// The page that `jrule explain` prints, in Markdown.
std::string_view explanation(Code code);

/// A secondary place with a few words about its part: "this node is added here".
struct Label {
  Span span;
  std::string text;
};

/// A certain correction: replace the text of `span`.
struct FixIt {
  Span span;
  std::string replacement;
  std::string text;  ///< "remove the second arc"
};

/// Wording: lower case, no full stop, `code` in backticks; says what was seen, in the user's spelling.
struct Diagnostic {
  Code code;
  Span span;                       ///< the narrowest range; file == no_file for problems without a place
  std::string message;
  std::vector<Label> labels{};
  std::vector<std::string> notes{};  ///< "in a 2-G-map every dart has exactly one 2-arc (paper, Def. 22)"
  std::vector<FixIt> fixits{};
  bool as_error = false;  ///< a warning that the user wants to be an error
};
/// Its code's, or error.
Severity severity(Diagnostic const& diagnostic);

class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }
  std::size_t error_count() const;
  bool has_errors() const { return error_count() != 0; }
  void make_errors_of_warnings();
  std::vector<Diagnostic> const& all() const { return all_; }
  /// By file, then position; those at one place in the order they were found. Exact repetitions once.
  std::vector<Diagnostic> sorted() const;

 private:
  std::vector<Diagnostic> all_;
};

struct HumanStyle {
  bool color = false;
};
/// First line GCC-shaped ("path:line:col: error: text [J0302]"), then the source line with carets, labels, notes and
/// fix-its. Without a place: "path: error: …" for a file that has no text, else "jrule: error: …". Ends with a newline.
std::string render_human(Sources const& sources, Diagnostic const& diagnostic, HumanStyle style = {});
/// One object on one line, with its newline: schema code severity message file line column endLine endColumn notes
/// labels fixits. Places that do not exist are null.
std::string render_json(Sources const& sources, Diagnostic const& diagnostic);

}  // namespace jrule::source

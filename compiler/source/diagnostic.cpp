#include "compiler/source/diagnostic.h"

#include <algorithm>
#include <tuple>

#include "compiler/source/pages.h"

namespace jrule::source {

namespace {

bool same(Label const& a, Label const& b) { return a.span == b.span && a.text == b.text; }

bool same(FixIt const& a, FixIt const& b) {
  return a.span == b.span && a.replacement == b.replacement && a.text == b.text;
}

bool same(Diagnostic const& a, Diagnostic const& b) {
  auto const each = [](auto const& x, auto const& y) { return same(x, y); };
  return a.code == b.code && a.span == b.span && a.message == b.message && a.notes == b.notes &&
         std::equal(a.labels.begin(), a.labels.end(), b.labels.begin(), b.labels.end(), each) &&
         std::equal(a.fixits.begin(), a.fixits.end(), b.fixits.begin(), b.fixits.end(), each);
}

auto place(Diagnostic const& d) { return std::tuple(d.span.file, d.span.begin); }

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

std::vector<CodeInfo> const& all_codes() {
  static std::vector<CodeInfo> const all{
#define JRULE_DIAGNOSTIC(number, name, severity, title) {Code::name, #number, #name, Severity::severity, title},
#include "compiler/source/diagnostics.def"
#undef JRULE_DIAGNOSTIC
  };
  return all;
}

CodeInfo const& info(Code code) { return all_codes()[static_cast<std::size_t>(code)]; }

CodeInfo const* find_code(std::string_view number) {
  auto const matches = [number](CodeInfo const& known) {
    return std::equal(known.number.begin(), known.number.end(), number.begin(), number.end(),
                      [](char a, char b) { return a == upper(b); });
  };
  auto const& all = all_codes();
  auto const found = std::find_if(all.begin(), all.end(), matches);
  return found == all.end() ? nullptr : &*found;
}

std::string_view explanation(Code code) {
  auto const number = info(code).number;
  auto const found = std::find_if(pages().begin(), pages().end(), [&](Page const& p) { return p.number == number; });
  return found == pages().end() ? std::string_view{} : found->text;
}

Severity severity(Diagnostic const& diagnostic) {
  Severity const own = info(diagnostic.code).severity;
  return diagnostic.as_error && own == Severity::warning ? Severity::error : own;
}

void Diagnostics::make_errors_of_warnings() {
  for (Diagnostic& diagnostic : all_) diagnostic.as_error = true;
}

std::size_t Diagnostics::error_count() const {
  return static_cast<std::size_t>(std::count_if(
      all_.begin(), all_.end(), [](Diagnostic const& d) { return severity(d) == Severity::error; }));
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> ordered = all_;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](Diagnostic const& a, Diagnostic const& b) { return place(a) < place(b); });
  std::vector<Diagnostic> result;
  for (auto& d : ordered) {
    // A repetition stands at the same place, so among the last ones kept.
    auto const there = std::find_if(result.rbegin(), result.rend(),
                                    [&](Diagnostic const& kept) { return place(kept) != place(d) || same(kept, d); });
    if (there == result.rend() || place(*there) != place(d)) result.push_back(std::move(d));
  }
  return result;
}

}  // namespace jrule::source

#include "tests/stdlib/stated.h"

#include <regex>
#include <set>

namespace jrule::test {

namespace {

constexpr std::string_view cell_letters = "vefc";

Sum read_sum(std::string const& text) {
  static std::regex const term(R"(([-+]?)\s*(\d*)([nvefc]?))");
  Sum sum;
  for (std::sregex_iterator at(text.begin(), text.end(), term), end; at != end; ++at) {
    std::string const sign = at->str(1), factor = at->str(2), letter = at->str(3);
    if (factor.empty() && letter.empty()) continue;
    sum[letter.empty() ? '1' : letter[0]] += (sign == "-" ? -1 : 1) * (factor.empty() ? 1 : std::stoll(factor));
  }
  return sum;
}

}  // namespace

std::vector<Stated> stated_counts(std::string const& comment) {
  static std::regex const statement(
      R"(\b([VEFC])(' =| [-+])(\s*(?:\d+[nvefc]?|[nvefc])\b(?:\s+[-+]\s+(?:\d+[nvefc]?|[nvefc])\b)*))");
  std::vector<Stated> found;
  for (std::sregex_iterator at(comment.begin(), comment.end(), statement), end; at != end; ++at) {
    std::string const what = at->str(2), sum = at->str(3);
    bool const total = what == "' =";
    found.push_back(
        {static_cast<int>(std::string_view("VEFC").find(at->str(1))), total, read_sum(total ? sum : what + sum)});
  }
  static std::regex const constant(R"(\b([VEFC]) stays\b)");
  for (std::sregex_iterator at(comment.begin(), comment.end(), constant), end; at != end; ++at) {
    found.push_back({static_cast<int>(std::string_view("VEFC").find(at->str(1))), false, {}});
  }
  return found;
}

Sum letters_of(Map const& map) {
  Summary const summary = summarize(map);
  Sum letters{{'1', 1}};
  for (std::size_t i = 0; i < summary.cells.size(); ++i)
    letters[cell_letters[i]] = static_cast<long long>(summary.cells[i]);
  return letters;
}

Sum letters_of(Map const& map, OrbitType const& hook_orbit, Dart hook) {
  std::vector<Dart> const darts = orbit(map, hook_orbit, hook);
  Sum letters{{'1', 1}};
  for (int i = 0; i <= map.model().dimension; ++i) {
    OrbitNumbers const cells = number_orbits(map, cell_orbit(map.model(), i).value());
    std::set<Dart> met;
    for (Dart const d : darts) met.insert(cells.number[d]);
    letters[cell_letters[static_cast<std::size_t>(i)]] = static_cast<long long>(met.size());
  }
  letters['n'] = letters.at('e');
  return letters;
}

long long value(Sum const& sum, Sum const& letters) {
  long long total = 0;
  for (auto const& [letter, factor] : sum) total += factor * letters.at(letter);
  return total;
}

}  // namespace jrule::test

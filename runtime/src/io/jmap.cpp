// .jmap: a whole map of any model as text (language reference, section 10). Blank lines mean nothing, nor does what
// follows a #.
//
//   jmap 1
//   model gmap 2                         a built-in model: its name and dimension
//   darts 4
//   1 3 0                                for each dart the targets of its arcs, dimensions ascending
//   …
//   embedding position Point3 2 <1,2>    name, type, number of values, orbit type as in a rule but without blanks
//   0 0 0                                a value: its components; Bool as 0 or 1
//   1 0 0
//   0 0 1 1                              the index of each dart's value; no such line if there are no darts
//
// Any other model gives its D, O and E, and `closed` if it is; an empty O or E is left out with its word:
//
//   model foo 2 dimensions 0 1 2 oriented 1 exchange 0,2 closed
//
// The orbit type of points may be left out: those of a file that says nothing else are on vertices.
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include <fmt/format.h>

#include "formats.h"
#include "text.h"
#include "jrule/io.h"

namespace jrule {
namespace {

using io::bad_input;
using io::parse_integer;
using io::quote;

constexpr Type all_types[] = {Type::Bool, Type::Int,    Type::Real,   Type::Vec2,
                              Type::Vec3, Type::Point2, Type::Point3, Type::Color};

/// An embedding as the file has it.
struct Column {
  std::string name;
  Type type = Type::Real;
  std::optional<OrbitType> orbit;
  std::size_t line = 0;
  std::vector<Value> values;
  std::vector<std::uint32_t> indices;  // of each dart
  std::size_t index_line = 0;
};

struct Content {
  Model model;
  std::size_t model_line = 0;
  std::vector<Dart> targets;  // dart by dart
  std::vector<std::size_t> dart_lines;
  std::vector<Column> columns;
};

/// "<1,2>", "<[2,~1],0>" without blanks; none if it is not so written or has a dimension that the model lacks.
std::optional<OrbitType> parse_orbit(std::string_view text, Model const& model) {
  std::size_t at = 0;
  auto const accept = [&](char c) {
    bool const found = at < text.size() && text[at] == c;
    at += found ? 1U : 0U;
    return found;
  };
  auto const letter = [&]() -> std::optional<Letter> {
    bool const conjugate = accept('~');
    if (at == text.size() || text[at] < '0' || text[at] > '9') return std::nullopt;
    int const dimension = text[at++] - '0';
    if (!model.has(dimension)) return std::nullopt;
    return Letter{static_cast<std::uint8_t>(dimension), conjugate && model.is_oriented(dimension)};
  };

  OrbitType orbit;
  if (!accept('<')) return std::nullopt;
  if (!accept('>')) {
    do {
      Word word;
      bool const brackets = accept('[');
      do {
        auto const next = letter();
        if (!next) return std::nullopt;
        word.push_back(*next);
      } while (brackets && accept(','));
      if (brackets && !accept(']')) return std::nullopt;
      orbit.words.push_back(std::move(word));
    } while (accept(','));
    if (!accept('>')) return std::nullopt;
  }
  if (at != text.size()) return std::nullopt;
  return orbit;
}

class Parser {
 public:
  Parser(std::string_view text, std::string const& file) : lines_(text), file_(file) {}

  Result<Content> parse();

 private:
  tl::unexpected<Error> error(std::string message) const {
    return bad_input(std::move(message), file_, lines_.number());
  }
  /// The words of the next line that has any; false at the end of the file.
  bool next_words() {
    while (auto const line = lines_.next()) {
      io::split(line->substr(0, line->find('#')), words_);
      if (!words_.empty()) return true;
    }
    return false;
  }
  Result<void> parse_model();
  Result<void> parse_darts();
  Result<void> parse_column();
  Result<Value> parse_value(Type type) const;

  io::Lines lines_;
  std::string const& file_;
  std::vector<std::string_view> words_;
  Content content_;
};

Result<Content> Parser::parse() {
  if (!next_words() || words_[0] != "jmap") return error("expected 'jmap 1'");
  if (words_.size() != 2 || words_[1] != "1") return error("only version 1 of the format is known");
  if (auto ok = parse_model(); !ok) return tl::unexpected(ok.error());
  if (auto ok = parse_darts(); !ok) return tl::unexpected(ok.error());
  while (next_words()) {
    if (words_[0] != "embedding") {
      return error("expected 'embedding' or the end of the file, found " + quote(words_[0]));
    }
    if (auto ok = parse_column(); !ok) return tl::unexpected(ok.error());
  }
  return std::move(content_);
}

Result<void> Parser::parse_model() {
  if (!next_words() || words_[0] != "model" || words_.size() < 3) {
    return error("expected 'model', a name and a dimension");
  }
  content_.model_line = lines_.number();
  auto const digit = [](std::string_view word) -> std::optional<int> {
    if (word.size() != 1 || word[0] < '0' || word[0] > '9') return std::nullopt;
    return word[0] - '0';
  };
  auto const n = digit(words_[2]);
  if (!n) return error(fmt::format("a dimension is in 0..9, found {}", quote(words_[2])));
  std::string const name(words_[1]);
  if (words_.size() == 3) {
    auto const known = builtin_model(name, *n);
    if (!known) return error(fmt::format("no built-in model {} of dimension {}; give its dimensions", quote(name), *n));
    content_.model = *known;
    return {};
  }

  Model& model = content_.model;
  model.name = name;
  model.dimension = *n;
  std::string_view section;
  for (std::size_t i = 3; i < words_.size(); ++i) {
    std::string_view const word = words_[i];
    if (word == "dimensions" || word == "oriented" || word == "exchange") {
      section = word;
    } else if (word == "closed") {
      model.closed = true;
      section = {};
    } else if (section == "exchange") {
      auto const a = digit(word.substr(0, 1));
      auto const b = word.size() == 3 && word[1] == ',' ? digit(word.substr(2)) : std::nullopt;
      if (!a || !b || !model.has(*a) || !model.has(*b) || *a >= *b) {
        return error(fmt::format("{} is not a pair i,j of the model's dimensions, i below j", quote(word)));
      }
      if (!model.exchange.empty() && model.exchange.back() >= std::pair(*a, *b)) {
        return error("the exchangeable pairs must ascend");
      }
      model.exchange.emplace_back(*a, *b);
    } else if (section == "dimensions" || section == "oriented") {
      auto const d = digit(word);
      if (!d) return error(fmt::format("a dimension is in 0..9, found {}", quote(word)));
      if (section == "oriented") {
        if (!model.has(*d)) return error(fmt::format("{} is oriented but no dimension of the model", *d));
        model.oriented = static_cast<std::uint16_t>(model.oriented | (1U << static_cast<unsigned>(*d)));
      } else {
        if (!model.dimensions.empty() && model.dimensions.back() >= *d) return error("the dimensions must ascend");
        model.dimensions.push_back(*d);
      }
    } else {
      return error(fmt::format("expected 'dimensions', 'oriented', 'exchange' or 'closed', found {}", quote(word)));
    }
  }
  if (model.dimensions.empty()) return error("the model has no dimensions");
  return {};
}

Result<void> Parser::parse_darts() {
  if (!next_words() || words_[0] != "darts" || words_.size() != 2) return error("expected 'darts' and their number");
  auto const count = parse_integer(words_[1]);
  if (!count || *count < 0 || *count >= std::int64_t{no_dart}) {
    return error(quote(words_[1]) + " is not a number of darts");
  }
  std::size_t const dimensions = content_.model.dimensions.size();
  for (std::int64_t d = 0; d < *count; ++d) {
    if (!next_words()) return error(fmt::format("the file ends after {} of {} darts", d, *count));
    if (words_.size() != dimensions) {
      return error(fmt::format("dart {} needs {} targets, found {}", d, dimensions, words_.size()));
    }
    for (std::string_view word : words_) {
      auto const target = parse_integer(word);
      if (!target || *target < 0 || *target >= *count) {
        return error(fmt::format("dart {}: {} is not a dart in 0..{}", d, quote(word), *count - 1));
      }
      content_.targets.push_back(static_cast<Dart>(*target));
    }
    content_.dart_lines.push_back(lines_.number());
  }
  return {};
}

Result<void> Parser::parse_column() {
  if (words_.size() != 4 && words_.size() != 5) {
    return error("expected 'embedding', a name, a type, the number of values and an orbit type");
  }
  Column column;
  column.name = std::string(words_[1]);
  column.line = lines_.number();
  for (Column const& other : content_.columns) {
    if (other.name == column.name) return error(fmt::format("a second embedding {}", quote(column.name)));
  }
  bool known = false;
  for (Type type : all_types) {
    if (to_string(type) != words_[2]) continue;
    column.type = type;
    known = true;
  }
  if (!known) return error("unknown type " + quote(words_[2]));
  auto const count = parse_integer(words_[3]);
  if (!count || *count < 0) return error(quote(words_[3]) + " is not a number of values");
  if (words_.size() == 5) {
    column.orbit = parse_orbit(words_[4], content_.model);
    if (!column.orbit) return error(quote(words_[4]) + " is not an orbit type of the model");
  }

  for (std::int64_t i = 0; i < *count; ++i) {
    if (!next_words()) return error(fmt::format("the file ends after {} of {} values of '{}'", i, *count, column.name));
    auto const value = parse_value(column.type);
    if (!value) return tl::unexpected(value.error());
    column.values.push_back(*value);
  }
  std::size_t const darts = content_.dart_lines.size();
  if (darts > 0) {
    if (!next_words()) return error(fmt::format("the file ends before the value indices of '{}'", column.name));
    if (words_.size() != darts) {
      return error(fmt::format("expected the value index of each of {} darts, found {}", darts, words_.size()));
    }
    column.index_line = lines_.number();
    for (std::size_t d = 0; d < darts; ++d) {
      auto const index = parse_integer(words_[d]);
      if (!index || *index < 0 || *index >= *count) {
        return error(fmt::format("dart {}: {} is not a value index; '{}' has {} values", d, quote(words_[d]),
                                 column.name, *count));
      }
      column.indices.push_back(static_cast<std::uint32_t>(*index));
    }
  }
  content_.columns.push_back(std::move(column));
  return {};
}

Result<Value> Parser::parse_value(Type type) const {
  std::size_t const size = static_cast<std::size_t>(component_count(type));
  if (words_.size() != size) {
    return error(fmt::format("a {} needs {} numbers, found {}", to_string(type), size, words_.size()));
  }
  if (type == Type::Bool || type == Type::Int) {  // not through doubles, which do not hold every integer
    auto const value = parse_integer(words_[0]);
    if (!value) return error(quote(words_[0]) + " is not an integer");
    if (type == Type::Int) return Value(*value);
    if (*value != 0 && *value != 1) return error(quote(words_[0]) + " is not a Bool, 0 or 1");
    return Value(*value == 1);
  }
  std::vector<double> components;
  for (std::string_view word : words_) {
    auto const value = io::parse_real(word);
    if (!value) return error(quote(word) + " is not a finite number");
    components.push_back(*value);
  }
  return from_components(type, components);
}

/// The line of the embedding whose values differ on an orbit of `map`.
std::size_t line_of_difference(Map const& map, std::vector<Column const*> const& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == nullptr) continue;
    Embedding const& e = map.embedding(i);
    OrbitNumbers const orbits = number_orbits(map, e.spec().orbit);
    for (Dart d = 0; d < map.dart_limit(); ++d) {
      if (e.value(e.handle(d)) != e.value(e.handle(orbits.first[orbits.number[d]]))) return columns[i]->index_line;
    }
  }
  return 0;
}

/// The map with these embeddings, each from its column; from its default where there is none.
Result<Map> build(Content const& content, std::vector<EmbeddingSpec> const& embeddings,
                  std::vector<Column const*> const& columns, std::string const& file) {
  Model const& model = content.model;
  auto map = io::make_map(model, embeddings, content.dart_lines.size(), file);
  if (!map) return map;
  // A Map needs each column to be a permutation before it can hold it.
  for (std::size_t k = 0; k < model.dimensions.size(); ++k) {
    int const i = model.dimensions[k];
    std::vector<Dart> incoming(map->dart_limit(), no_dart);
    for (Dart d = 0; d < map->dart_limit(); ++d) {
      Dart const to = content.targets[d * model.dimensions.size() + k];
      if (incoming[to] != no_dart) {
        return bad_input(fmt::format("dart {}: its {}-arc leads to dart {}, and so does the {}-arc of dart {}", d, i,
                                     to, i, incoming[to]),
                         file, content.dart_lines[d]);
      }
      incoming[to] = d;
      map->set_target(d, i, to);
    }
  }
  for (std::size_t i = 0; i < embeddings.size(); ++i) {
    if (columns[i] == nullptr) {
      if (auto ok = io::set_default(*map, i, file); !ok) return tl::unexpected(ok.error());
      continue;
    }
    Embedding& e = map->embedding(i);
    e.reserve_values(columns[i]->values.size());
    for (Value const& value : columns[i]->values) e.add(value);
    for (Dart d = 0; d < map->dart_limit(); ++d) e.set_handle(d, columns[i]->indices[d]);
    e.compact();
  }
  if (auto const violation = find_violation(*map)) {
    bool const of_values = violation->kind == Violation::Kind::embedding;
    return bad_input(violation->text, file,
                     of_values ? line_of_difference(*map, columns) : content.dart_lines[violation->dart]);
  }
  return map;
}

void append_value(fmt::memory_buffer& out, Value const& value) {
  if (auto const* i = std::get_if<std::int64_t>(&value)) {
    fmt::format_to(fmt::appender(out), "{}", *i);
    return;
  }
  for (int k = 0; k < component_count(type_of(value)); ++k) {
    if (k > 0) out.push_back(' ');
    fmt::format_to(fmt::appender(out), "{}", component(value, k));
  }
}

std::string cannot_hold(EmbeddingSpec const& spec) {
  return fmt::format("the embedding '{}' has the C++ type {}, which .jmap cannot hold", spec.name, spec.extern_name);
}

}  // namespace

Result<Map> parse_jmap(std::string_view text, std::string const& path) {
  auto const content = Parser(text, path).parse();
  if (!content) return tl::unexpected(content.error());
  std::vector<EmbeddingSpec> embeddings;
  std::vector<Column const*> columns;
  for (Column const& column : content->columns) {
    bool const is_point = column.type == Type::Point2 || column.type == Type::Point3;
    auto const orbit = column.orbit ? column.orbit : is_point ? cell_orbit(content->model, 0) : std::nullopt;
    if (!orbit) {
      return bad_input(fmt::format("the orbit type of embedding '{}' is missing", column.name), path, column.line);
    }
    embeddings.push_back({column.name, *orbit, column.type, std::nullopt, MergePolicy::none});
    columns.push_back(&column);
  }
  return build(*content, embeddings, columns, path);
}

std::string print_jmap(Map const& map) {
  Model const& model = map.model();
  fmt::memory_buffer out;
  auto const print = [&]<class... Args>(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(fmt::appender(out), format, std::forward<Args>(args)...);
  };
  print("jmap 1\nmodel {} {}", model.name, model.dimension);
  if (builtin_model(model.name, model.dimension) != model) {
    print(" dimensions");
    for (int d : model.dimensions) print(" {}", d);
    if (model.oriented != 0) print(" oriented");
    for (int d : model.dimensions) {
      if (model.is_oriented(d)) print(" {}", d);
    }
    if (!model.exchange.empty()) print(" exchange");
    for (auto const& [i, j] : model.exchange) print(" {},{}", i, j);
    if (model.closed) print(" closed");
  }

  std::vector<Dart> const darts = map.darts();
  std::vector<Dart> numbers(map.dart_limit(), no_dart);
  for (std::size_t k = 0; k < darts.size(); ++k) numbers[darts[k]] = static_cast<Dart>(k);
  print("\ndarts {}\n", darts.size());
  for (Dart d : darts) {
    std::string_view separator;
    for (int i : model.dimensions) {
      Dart const to = map.target(d, i);
      if (map.contains(to)) print("{}{}", separator, numbers[to]);
      else print("{}-", separator);  // of a map that is not valid: for the eye, no reader takes it
      separator = " ";
    }
    print("\n");
  }

  for (std::size_t i = 0; i < map.embedding_count(); ++i) {
    Embedding const& e = map.embedding(i);
    if (e.spec().type == Type::Extern) throw std::invalid_argument(cannot_hold(e.spec()));
    // Equal values are one, so that the text does not depend on which handles the orbits happen to share.
    constexpr std::uint32_t unset = 0xffffffffU;
    std::vector<std::uint32_t> index_of_handle(e.value_count(), unset);
    std::unordered_map<std::string, std::uint32_t> index_of_text;
    fmt::memory_buffer values;
    fmt::memory_buffer indices;
    for (Dart d : darts) {
      if (indices.size() != 0) indices.push_back(' ');
      Handle const h = e.handle(d);
      if (h >= index_of_handle.size()) {
        indices.push_back('-');  // as above
        continue;
      }
      if (index_of_handle[h] == unset) {
        fmt::memory_buffer text;
        append_value(text, e.value(h));
        text.push_back('\n');
        auto const [it, is_new] =
            index_of_text.try_emplace(fmt::to_string(text), static_cast<std::uint32_t>(index_of_text.size()));
        index_of_handle[h] = it->second;
        if (is_new) values.append(text);
      }
      fmt::format_to(fmt::appender(indices), "{}", index_of_handle[h]);
    }
    print("embedding {} {} {} {}\n", e.spec().name, to_string(e.spec().type), index_of_text.size(),
          to_string(e.spec().orbit));
    out.append(values);
    out.append(indices);
    if (!darts.empty()) print("\n");
  }
  return fmt::to_string(out);
}

namespace io {

Result<Map> parse_jmap_as(std::string_view text, std::string const& file, Model const& model,
                          std::vector<EmbeddingSpec> const& embeddings) {
  auto const content = Parser(text, file).parse();
  if (!content) return tl::unexpected(content.error());
  if (content->model != model) {
    Model const& found = content->model;
    bool const same_name = found.name == model.name && found.dimension == model.dimension;
    return bad_input(same_name ? fmt::format("the file's model {}({}) has other constraints than the one expected",
                                             found.name, found.dimension)
                               : fmt::format("a map of {}({}), expected one of {}({})", found.name, found.dimension,
                                             model.name, model.dimension),
                     file, content->model_line);
  }
  std::vector<Column const*> columns;
  for (EmbeddingSpec const& spec : embeddings) {
    Column const* found = nullptr;
    for (Column const& column : content->columns) {
      if (column.name == spec.name) found = &column;
    }
    columns.push_back(found);
    if (found == nullptr) continue;
    if (spec.type == Type::Extern) return bad_input(cannot_hold(spec), file, found->line);
    if (found->type != spec.type) {
      return bad_input(fmt::format("embedding '{}' has type {}, expected {}", spec.name, to_string(found->type),
                                   to_string(spec.type)),
                       file, found->line);
    }
    if (found->orbit && !same_orbit(model, *found->orbit, spec.orbit)) {
      return bad_input(fmt::format("embedding '{}' is on {}, expected {}", spec.name, to_string(*found->orbit),
                                   to_string(spec.orbit)),
                       file, found->line);
    }
  }
  return build(*content, embeddings, columns, file);
}

Result<std::string> print_checked_jmap(Map const& map) {
  for (std::size_t i = 0; i < map.embedding_count(); ++i) {
    Embedding const& e = map.embedding(i);
    if (e.spec().type == Type::Extern) return fail(Error::Kind::bad_input, cannot_hold(e.spec()));
    for (Dart d : map.darts()) {
      Handle const h = e.handle(d);
      if (h >= e.value_count()) {
        return fail(Error::Kind::bad_input, fmt::format("dart {} has no value of '{}'", d, e.spec().name));
      }
      Value const value = e.value(h);
      for (int k = 0; k < component_count(type_of(value)); ++k) {
        if (!std::isfinite(component(value, k))) {
          return fail(Error::Kind::bad_input, fmt::format("dart {} has a '{}' that is not finite", d, e.spec().name));
        }
      }
    }
  }
  return print_jmap(map);
}

}  // namespace io

}  // namespace jrule

// PLY, ascii and binary in both byte orders. Read are x, y and z of the element `vertex` and the list `vertex_indices`
// (or `vertex_index`) of the element `face`; other properties and elements are passed over.
#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "bytes.h"
#include "formats.h"
#include "text.h"

namespace jrule::io {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding { ascii, little_endian, big_endian };
/// What a property is to a surface.
enum class Role { none, x, y, z, corners };

struct Property {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count_type;  // of a list
  Role role = Role::none;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

bool is_real(Scalar type) { return type == Scalar::float32 || type == Scalar::float64; }

std::optional<Scalar> scalar_type(std::string_view name) {
  struct Name {
    std::string_view old, sized;
  };
  constexpr Name names[] = {{"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
                            {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (name == names[i].old || name == names[i].sized) return static_cast<Scalar>(i);
  }
  return std::nullopt;
}

Role role_of(std::string_view element, Property const& property) {
  std::string_view const name = property.name;
  if (element == "face" && (name == "vertex_indices" || name == "vertex_index")) return Role::corners;
  if (element != "vertex") return Role::none;
  return name == "x" ? Role::x : name == "y" ? Role::y : name == "z" ? Role::z : Role::none;
}

/// Reads up to the line end_header.
Result<Header> parse_header(Lines& lines, std::string const& file) {
  Header header;
  std::vector<std::string_view> words;
  auto const error = [&](std::string message) { return bad_input(std::move(message), file, lines.number()); };
  if (auto const magic = lines.next(); magic != "ply") {
    return error("expected 'ply', found " + quote(magic.value_or("")));
  }

  bool has_format = false;
  while (auto const line = lines.next()) {
    split(*line, words);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format") {
      if (has_format) return error("a second format");
      if (words.size() != 3 || words[2] != "1.0") return error("expected a format and its version 1.0");
      if (words[1] == "ascii") header.encoding = Encoding::ascii;
      else if (words[1] == "binary_little_endian") header.encoding = Encoding::little_endian;
      else if (words[1] == "binary_big_endian") header.encoding = Encoding::big_endian;
      else return error("unknown format " + quote(words[1]));
      has_format = true;
    } else if (words[0] == "element") {
      if (words.size() != 3) return error("expected 'element', a name and a count");
      auto const count = parse_integer(words[2]);
      if (!count || *count < 0) return error(quote(words[2]) + " is not a count");
      for (Element const& e : header.elements) {
        if (e.name == words[1]) return error(fmt::format("a second element {}", quote(words[1])));
      }
      header.elements.push_back({std::string(words[1]), *count, {}});
    } else if (words[0] == "property") {
      bool const is_list = words.size() > 1 && words[1] == "list";
      if (words.size() != (is_list ? 5U : 3U)) return error("expected 'property', a type and a name");
      if (header.elements.empty()) return error("a property before the first element");
      Element& element = header.elements.back();
      Property property;
      property.name = std::string(words.back());
      for (std::size_t i = is_list ? 2 : 1; i + 1 < words.size(); ++i) {
        auto const type = scalar_type(words[i]);
        if (!type) return error("unknown type " + quote(words[i]));
        if (is_list && i == 2) property.count_type = *type;
        else property.type = *type;
      }
      if (property.count_type && is_real(*property.count_type)) return error("the length of a list must be an integer");
      property.role = role_of(element.name, property);
      if (property.role != Role::none) {
        bool const right = property.role == Role::corners ? is_list && !is_real(property.type) : !is_list;
        if (!right) {
          return error(
              fmt::format("property {} of element '{}' has the wrong type", quote(property.name), element.name));
        }
        for (Property const& p : element.properties) {
          if (p.role == property.role) return error(fmt::format("a second property {}", quote(property.name)));
        }
      }
      element.properties.push_back(std::move(property));
    } else if (words[0] == "end_header") {
      if (!has_format) return error("the header has no format");
      auto const require = [&](std::string_view element, std::size_t roles) {
        for (Element const& e : header.elements) {
          if (e.name != element) continue;
          std::size_t found = 0;
          for (Property const& p : e.properties) found += p.role != Role::none ? 1U : 0U;
          return found == roles;  // no role is there twice
        }
        return false;
      };
      if (!require("vertex", 3)) return error("no element 'vertex' with properties x, y and z");
      if (!require("face", 1)) return error("no element 'face' with a list vertex_indices");
      return header;
    } else {
      return error("unknown keyword " + quote(words[0]));
    }
  }
  return error("the file ends inside the header");
}

/// The numbers after the header, one after the other, in either encoding.
class Body {
 public:
  Body(Lines lines, Encoding encoding, std::string_view bytes, std::string const& file)
      : lines_(lines), encoding_(encoding), bytes_(bytes), at_(bytes.size() - lines.rest().size()), file_(file) {}

  bool is_binary() const noexcept { return encoding_ != Encoding::ascii; }
  /// Where the last number was: its line, or in a binary file its byte offset.
  std::size_t place() const noexcept { return is_binary() ? at_ : lines_.number(); }
  tl::unexpected<Error> error(std::string message) const {
    if (!is_binary()) return bad_input(std::move(message), file_, lines_.number());
    return bad_input(fmt::format("{} (at byte {})", message, at_), file_, 0);
  }

  /// In an ascii file each item of an element is a line. False at the end of the file.
  bool begin_item() {
    word_ = 0;
    if (is_binary()) return at_ < bytes_.size();
    while (auto line = lines_.next()) {
      split(*line, words_);
      if (!words_.empty()) return true;
    }
    return false;
  }
  bool item_has_more() const noexcept { return !is_binary() && word_ < words_.size(); }

  /// PLY's integers have at most 32 bits: a double holds each number exactly.
  Result<double> number(Scalar type) {
    if (is_binary()) return decode(type);
    auto const word = next_word();
    if (!word) return tl::unexpected(word.error());
    auto const value = is_real(type) ? parse_real(*word) : as_real(parse_integer(*word));
    if (!value) return error(quote(*word) + (is_real(type) ? " is not a finite number" : " is not an integer"));
    return *value;
  }
  /// Passes over a number without a look at it: a normal that is not finite does no harm.
  Result<void> skip(Scalar type) {
    if (is_binary()) {
      auto const value = decode(type);
      if (!value) return tl::unexpected(value.error());
    } else if (auto const word = next_word(); !word) {
      return tl::unexpected(word.error());
    }
    return {};
  }

 private:
  static std::optional<double> as_real(std::optional<std::int64_t> value) {
    if (!value) return std::nullopt;
    return static_cast<double>(*value);
  }
  Result<std::string_view> next_word() {
    if (word_ == words_.size()) return error("a number is missing on this line");
    return words_[word_++];
  }
  template <class T>
  Result<double> decode_as() {
    if (bytes_.size() - at_ < sizeof(T)) return error("the file ends inside an element");
    T const value = load<T>(bytes_, at_, encoding_ == Encoding::little_endian ? std::endian::little : std::endian::big);
    at_ += sizeof(T);
    return static_cast<double>(value);
  }
  Result<double> decode(Scalar type) {
    switch (type) {
      case Scalar::int8: return decode_as<std::int8_t>();
      case Scalar::uint8: return decode_as<std::uint8_t>();
      case Scalar::int16: return decode_as<std::int16_t>();
      case Scalar::uint16: return decode_as<std::uint16_t>();
      case Scalar::int32: return decode_as<std::int32_t>();
      case Scalar::uint32: return decode_as<std::uint32_t>();
      case Scalar::float32: return decode_as<float>();
      case Scalar::float64: break;
    }
    return decode_as<double>();
  }

  Lines lines_;
  Encoding encoding_;
  std::string_view bytes_;
  std::size_t at_;
  std::string const& file_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

Result<void> read_corners(Body& body, Property const& property, Surface& surface) {
  auto const count = body.number(*property.count_type);
  if (!count) return tl::unexpected(count.error());
  if (*count < 0) return body.error(fmt::format("a list has the length {}", *count));
  for (double i = 0; i < *count; ++i) {
    auto const index = body.number(property.type);
    if (!index) return tl::unexpected(index.error());
    auto const corner = std::abs(*index) < 1e18 ? to_corner(static_cast<std::int64_t>(*index)) : std::nullopt;
    if (!corner) return body.error(fmt::format("there is no vertex {}", *index));
    surface.corners.push_back(*corner);
  }
  return {};
}

Result<void> skip_property(Body& body, Property const& property) {
  double count = 1;
  if (property.count_type) {
    auto const length = body.number(*property.count_type);
    if (!length) return tl::unexpected(length.error());
    count = *length;
  }
  for (double i = 0; i < count; ++i) {
    if (auto ok = body.skip(property.type); !ok) return ok;
  }
  return {};
}

Result<void> read_item(Body& body, Element const& element, Surface& surface) {
  Point3 point;
  for (Property const& property : element.properties) {
    if (property.role == Role::none) {
      if (auto ok = skip_property(body, property); !ok) return ok;
    } else if (property.role == Role::corners) {
      if (auto ok = read_corners(body, property, surface); !ok) return ok;
    } else {
      auto const value = body.number(property.type);
      if (!value) return tl::unexpected(value.error());
      if (!std::isfinite(*value)) return body.error("a coordinate is not a finite number");
      (property.role == Role::x ? point.x : property.role == Role::y ? point.y : point.z) = *value;
    }
  }
  if (body.item_has_more()) return body.error(fmt::format("more numbers than element '{}' has", element.name));
  if (element.name == "vertex") surface.points.push_back(point);
  return {};
}

}  // namespace

Result<Surface> parse_ply(std::string_view bytes, std::string const& file) {
  Lines lines(bytes);
  auto const header = parse_header(lines, file);
  if (!header) return tl::unexpected(header.error());

  Body body(lines, header->encoding, bytes, file);
  Surface surface;
  surface.first_index = 0;
  surface.binary = body.is_binary();
  for (Element const& element : header->elements) {
    if (element.properties.empty()) continue;  // nothing of it is in the file, whatever its count
    for (std::int64_t i = 0; i < element.count; ++i) {
      std::size_t const begin = body.place();
      if (!body.begin_item()) {
        return body.error(
            fmt::format("the file ends after {} of {} items of element '{}'", i, element.count, element.name));
      }
      if (auto ok = read_item(body, element, surface); !ok) return tl::unexpected(ok.error());
      if (element.name == "face") surface.end_face(body.is_binary() ? begin : body.place());
    }
  }
  if (body.begin_item()) return body.error("more data than the header promises");
  surface.end = body.place();
  return surface;
}

Result<std::string> print_ply(Surface const& surface) {
  std::size_t longest = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) longest = std::max(longest, surface.face(f).size());
  fmt::memory_buffer out;
  fmt::format_to(fmt::appender(out),
                 "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
                 "element face {}\nproperty list {} int vertex_indices\nend_header\n",
                 surface.points.size(), surface.face_count(), longest < 256 ? "uchar" : "int");
  for (Point3 const& p : surface.points) fmt::format_to(fmt::appender(out), "{} {} {}\n", p.x, p.y, p.z);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    fmt::format_to(fmt::appender(out), "{}", surface.face(f).size());
    for (std::uint32_t corner : surface.face(f)) fmt::format_to(fmt::appender(out), " {}", corner);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace jrule::io

// STL, ascii and binary: triangles without shared vertices. Corners at the same point become one vertex.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

#include "bytes.h"
#include "formats.h"
#include "text.h"

namespace jrule::io {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t prefix_size = header_size + 4;  // the header, then the number of triangles
constexpr std::size_t triangle_size = 50;             // normal, three points, two bytes of attributes

/// One vertex for each point. Points are told apart by their bits, save that the two zeros are one.
class Welder {
 public:
  explicit Welder(Surface& surface) : surface_(surface) {}

  void add_corner(Point3 const& p) {
    auto const [it, is_new] = vertices_.try_emplace(key(p), static_cast<std::uint32_t>(surface_.points.size()));
    if (is_new) surface_.points.push_back(p);
    surface_.corners.push_back(it->second);
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(Key const& k) const noexcept {
      std::uint64_t h = 0;
      for (std::uint64_t word : k) {
        h = (h ^ word) * 0x9e3779b97f4a7c15U;
        h ^= h >> 29U;
      }
      return static_cast<std::size_t>(h);
    }
  };
  static Key key(Point3 const& p) {
    return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
            std::bit_cast<std::uint64_t>(p.z + 0.0)};
  }

  Surface& surface_;
  std::unordered_map<Key, std::uint32_t, Hash> vertices_;
};

Result<Surface> parse_binary(std::string_view bytes, std::string const& file) {
  Surface surface;
  surface.binary = true;
  Welder welder(surface);
  for (std::size_t at = prefix_size; at < bytes.size(); at += triangle_size) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      float xyz[3] = {};
      for (std::size_t k = 0; k < 3; ++k) {
        std::size_t const place = at + 12 + 12 * corner + 4 * k;
        xyz[k] = load<float>(bytes, place, std::endian::little);
        if (!std::isfinite(xyz[k])) {
          return bad_input(fmt::format("a coordinate is not a finite number (at byte {})", place), file, 0);
        }
      }
      welder.add_corner({xyz[0], xyz[1], xyz[2]});
    }
    surface.end_face(at);
  }
  return surface;
}

/// The words of the file in lower case, whatever the lines.
class Words {
 public:
  explicit Words(std::string_view text) : lines_(text) {}

  /// The next word; empty at the end of the file.
  std::string next() {
    while (at_ == words_.size()) {
      auto const line = lines_.next();
      if (!line) return {};
      split(*line, words_);
      at_ = 0;
    }
    std::string word(words_[at_++]);
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word;
  }
  void skip_line() { at_ = words_.size(); }
  std::size_t line() const noexcept { return lines_.number(); }

 private:
  Lines lines_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

Result<Surface> parse_ascii(std::string_view text, std::string const& file) {
  Surface surface;
  Welder welder(surface);
  Words words(text);
  auto const unexpected = [&](std::string_view expected, std::string_view found) {
    return bad_input(
        fmt::format("expected '{}', found {}", expected, found.empty() ? "the end of the file" : quote(found)), file,
        words.line());
  };
  auto const expect = [&](std::string_view keyword) -> Result<void> {
    if (std::string const word = words.next(); word != keyword) return unexpected(keyword, word);
    return {};
  };

  for (std::string solid = words.next(); !solid.empty(); solid = words.next()) {
    if (solid != "solid") return unexpected("solid", solid);
    words.skip_line();  // its name
    for (std::string word = words.next(); word != "endsolid"; word = words.next()) {
      if (word != "facet") return unexpected("facet", word);
      std::size_t const line = words.line();
      words.skip_line();  // its normal: what the corners say decides
      for (auto keyword : {"outer", "loop"}) {
        if (auto ok = expect(keyword); !ok) return tl::unexpected(ok.error());
      }
      for (int corner = 0; corner < 3; ++corner) {
        if (auto ok = expect("vertex"); !ok) return tl::unexpected(ok.error());
        double xyz[3] = {};
        for (double& coordinate : xyz) {
          std::string const number = words.next();
          auto const value = parse_real(number);
          if (!value) return bad_input(quote(number) + " is not a finite number", file, words.line());
          coordinate = *value;
        }
        welder.add_corner({xyz[0], xyz[1], xyz[2]});
      }
      for (auto keyword : {"endloop", "endfacet"}) {
        if (auto ok = expect(keyword); !ok) return tl::unexpected(ok.error());
      }
      surface.end_face(line);
    }
    words.skip_line();  // the name again
  }
  surface.end = words.line();
  return surface;
}

}  // namespace

// Many binary files begin with "solid" too. So the size decides, which in a binary file follows from the number of
// triangles; a file of another size is text, or a binary file cut off, and text has no zero bytes.
Result<Surface> parse_stl(std::string_view bytes, std::string const& file) {
  std::uint64_t const count =
      bytes.size() < prefix_size ? 0 : load<std::uint32_t>(bytes, header_size, std::endian::little);
  std::uint64_t const size = prefix_size + triangle_size * count;
  if (bytes.size() >= prefix_size && bytes.size() == size) return parse_binary(bytes, file);
  if (bytes.find('\0') == std::string_view::npos) return parse_ascii(bytes, file);
  if (bytes.size() < prefix_size) {
    return bad_input(
        fmt::format("a binary STL file has {} bytes or more, this one ends at byte {}", prefix_size, bytes.size()),
        file, 0);
  }
  return bad_input(fmt::format("a binary STL file of {} triangles has {} bytes, this one ends at byte {}", count, size,
                               bytes.size()),
                   file, 0);
}

Result<std::string> print_stl(Surface const& surface) {
  using Triangle = std::array<std::array<float, 3>, 3>;
  std::string out = "jrule";
  out.resize(header_size, ' ');
  std::size_t const count = surface.corners.size() - 2 * surface.face_count();
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    return fail(Error::Kind::bad_input, fmt::format("{} triangles are more than an STL file holds", count));
  }
  out.reserve(prefix_size + triangle_size * count);
  store(out, static_cast<std::uint32_t>(count));

  auto const as_float = [&](std::uint32_t vertex) {
    Point3 const& p = surface.points[vertex];
    return std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    auto const face = surface.face(f);
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      std::uint32_t const vertices[3] = {face[0], face[k], face[k + 1]};
      for (std::uint32_t vertex : vertices) {
        Point3 const& p = surface.points[vertex];
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > double{std::numeric_limits<float>::max()}) {
          return fail(Error::Kind::bad_input, fmt::format("vertex {} is beyond the range of STL's numbers", vertex));
        }
      }
      Triangle const t{as_float(vertices[0]), as_float(vertices[1]), as_float(vertices[2])};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        return fail(Error::Kind::bad_input,
                    fmt::format("vertices {}, {} and {} are not three points in STL's precision", vertices[0],
                                vertices[1], vertices[2]));
      }
      double u[3], v[3];
      for (std::size_t i = 0; i < 3; ++i) {
        u[i] = double{t[1][i]} - double{t[0][i]};
        v[i] = double{t[2][i]} - double{t[0][i]};
      }
      double const n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      double const length = std::hypot(n[0], n[1], n[2]);
      for (double x : n) store(out, length > 0 ? static_cast<float>(x / length) : 0.0F);
      for (auto const& point : t) {
        for (float x : point) store(out, x);
      }
      store(out, std::uint16_t{0});
    }
  }
  return out;
}

}  // namespace jrule::io

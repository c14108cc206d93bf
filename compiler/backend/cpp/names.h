// Names that C++ can use. A module's rules and embeddings keep theirs or are refused (J0901); what is only seen inside
// a function or as a member of a result (hooks, parameters, nodes) gets a `_` appended where C++ cannot use it:
// `delete_`.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace jrule::cpp {

/// Why C++ cannot use the name: "is a keyword of C++"; empty if it can.
std::string_view unusable(std::string_view name);

/// An identifier as close to the text as C++ allows: "class" gives "class_", "sew[2]" gives "sew_2".
std::string identifier(std::string_view text);

/// "quad_subdivision" gives "QuadSubdivision".
std::string camel_case(std::string_view name);
/// "HalfEdges" gives "half_edges".
std::string snake_case(std::string_view name);
/// The namespace of a module: "surface" for "std.surface". Never the name of a function of the C library, which lies in
/// the global namespace too.
std::string namespace_of(std::string_view module);

/// The names of one C++ scope.
class Scope {
 public:
  /// The identifier for `wanted` if it is free, else the next free one: "a", "a_", "a_2", "a_3".
  std::string take(std::string_view wanted);
  /// False if it was taken.
  bool reserve(std::string const& name) { return taken_.insert(name).second; }

 private:
  std::set<std::string, std::less<>> taken_;
};

}  // namespace jrule::cpp

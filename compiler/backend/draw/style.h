// What all pictures have in common.
#pragma once

#include <string>
#include <string_view>

namespace jrule::draw {

/// The colour of arcs of that dimension: those of the papers for 0 to 2, black, red and blue.
char const* color_of(int dimension);

/// The text as content of an element or an attribute of XML; what XML cannot hold becomes U+FFFD.
std::string escape(std::string_view text);

// Nodes and darts that come and go.
inline constexpr char const *added_color = "#c8e6c9", *deleted_color = "#ffcdd2";

}  // namespace jrule::draw

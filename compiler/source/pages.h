// The pages of explain/, embedded when the library is built.
#pragma once

#include <string_view>
#include <vector>

namespace jrule::source {

struct Page {
  std::string_view number;  ///< "J0302"
  std::string_view text;    ///< Markdown
};

std::vector<Page> const& pages();

}  // namespace jrule::source

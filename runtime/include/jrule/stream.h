// Columns that follow from their index or from one other column: how generated code writes most of what it adds to a map. They
// are written as fast as the memory takes them, whatever options the generated code is compiled with.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jrule::stream {

/// column[k] = first + k for each k in [begin, end). Cost: the writing of it.
void count_up(std::uint32_t* column, std::size_t begin, std::size_t end, std::size_t first) noexcept;

/// column[k] = first + from[k] for each k in [begin, end). `column` and `from` are the same or do not overlap.
void shift(std::uint32_t* column, std::uint32_t const* from, std::size_t begin, std::size_t end, std::size_t first) noexcept;

}  // namespace jrule::stream

// Numbers as bytes in a given order, whatever the order of this machine.
#pragma once

#include <bit>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace jrule::io {

/// The unsigned integer of as many bytes as T has.
template <class T>
using Bits = std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                std::conditional_t<sizeof(T) == 2, std::uint16_t,
                                                   std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// The number whose bytes begin at `at`; the caller knows that they are there.
template <class T>
T load(std::string_view bytes, std::size_t at, std::endian order) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    std::size_t const place = order == std::endian::little ? sizeof(T) - 1 - i : i;
    bits = (bits << CHAR_BIT) | static_cast<unsigned char>(bytes[at + place]);
  }
  return std::bit_cast<T>(static_cast<Bits<T>>(bits));
}

/// Appends a number, least byte first.
template <class T>
void store(std::string& bytes, T value) {
  auto const bits = std::bit_cast<Bits<T>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>((bits >> (CHAR_BIT * i)) & 0xffU);
}

}  // namespace jrule::io

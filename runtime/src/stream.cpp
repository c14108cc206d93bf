#include "jrule/stream.h"

// The same loops for the widest registers that the processor has: with those of every x86-64, storing takes twice as long as
// what the caches and the memory behind them need.
#if defined(__x86_64__) && defined(__GNUC__)
#define JRULE_WIDE_REGISTERS 1
#endif

namespace jrule::stream {

namespace {

[[gnu::always_inline]] inline void count_loop(std::uint32_t* column, std::size_t begin, std::size_t end, std::size_t first) noexcept {
  for (std::size_t k = begin; k < end; ++k) column[k] = static_cast<std::uint32_t>(first + k);
}

[[gnu::always_inline]] inline void shift_loop(std::uint32_t* column, std::uint32_t const* from, std::size_t begin, std::size_t end,
                                              std::size_t first) noexcept {
  auto const by = static_cast<std::uint32_t>(first);
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep  // each index reads what it writes itself, or what none writes
#endif
  for (std::size_t k = begin; k < end; ++k) column[k] = by + from[k];
}

#ifdef JRULE_WIDE_REGISTERS

enum class Registers { narrow, wide, widest };

Registers registers() noexcept {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) return Registers::widest;
  return __builtin_cpu_supports("avx2") ? Registers::wide : Registers::narrow;
}

[[gnu::target("avx512f,avx512vl")]] void count_widest(std::uint32_t* column, std::size_t begin, std::size_t end, std::size_t first) noexcept {
  count_loop(column, begin, end, first);
}
[[gnu::target("avx2")]] void count_wide(std::uint32_t* column, std::size_t begin, std::size_t end, std::size_t first) noexcept {
  count_loop(column, begin, end, first);
}
[[gnu::target("avx512f,avx512vl")]] void shift_widest(std::uint32_t* column, std::uint32_t const* from, std::size_t begin, std::size_t end,
                                                      std::size_t first) noexcept {
  shift_loop(column, from, begin, end, first);
}
[[gnu::target("avx2")]] void shift_wide(std::uint32_t* column, std::uint32_t const* from, std::size_t begin, std::size_t end,
                                        std::size_t first) noexcept {
  shift_loop(column, from, begin, end, first);
}

#endif

}  // namespace

void count_up(std::uint32_t* column, std::size_t begin, std::size_t end, std::size_t first) noexcept {
#ifdef JRULE_WIDE_REGISTERS
  if (registers() == Registers::widest) return count_widest(column, begin, end, first);
  if (registers() == Registers::wide) return count_wide(column, begin, end, first);
#endif
  count_loop(column, begin, end, first);
}

void shift(std::uint32_t* column, std::uint32_t const* from, std::size_t begin, std::size_t end, std::size_t first) noexcept {
#ifdef JRULE_WIDE_REGISTERS
  if (registers() == Registers::widest) return shift_widest(column, from, begin, end, first);
  if (registers() == Registers::wide) return shift_wide(column, from, begin, end, first);
#endif
  shift_loop(column, from, begin, end, first);
}

}  // namespace jrule::stream

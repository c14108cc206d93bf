// The memory of columns: large arrays that are written as streams.
#pragma once

#include <cstddef>

namespace jrule::memory {

/// Memory whose content is unset. Asks for large pages where there is much: with small ones their first touch costs more than
/// what is written to them. Throws std::bad_alloc.
void* allocate(std::size_t bytes, std::size_t alignment);
void deallocate(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

/// Has what allocate() gave for so many bytes pages of its own? Then grow() may be called.
bool has_own_pages(std::size_t bytes) noexcept;
/// Memory of more bytes that begins with all that is in `memory`, which is gone: it lies elsewhere, but in the same pages, so that
/// nothing is copied. Throws std::bad_alloc; then `memory` is as it was. O(pages).
void* grow(void* memory, std::size_t bytes, std::size_t more_bytes);

/// Memory whose bytes are all zero; what is never touched costs nothing. Throws std::bad_alloc.
void* allocate_zeros(std::size_t bytes);
void deallocate_zeros(void* memory, std::size_t bytes) noexcept;

}  // namespace jrule::memory

// Memory for a direction tree and its twigs: blocks on large pages where the system grants them.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rectilin {

/// Allocates `wanted` bytes, uninitialised, aligned to at least two cache lines. A query of a large tree reads a few
/// lines in each of thousands of places; on small pages nearly each of these would also miss the translation
/// lookaside buffer.
inline std::shared_ptr<std::byte[]> allocate_nodes(std::size_t wanted) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  constexpr std::size_t kLines = 128;
  const std::size_t alignment = wanted >= kPage ? kPage : kLines;
  const std::size_t bytes = (wanted + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, bytes);
  if (memory == nullptr && bytes > 0) throw std::bad_alloc();
#ifdef __linux__
  if (alignment == kPage) madvise(memory, bytes, MADV_HUGEPAGE);  // only a hint
#endif
  return {static_cast<std::byte*>(memory), [](std::byte* p) { std::free(p); }};
}

}  // namespace rectilin

// Arrays that share no cache line with anything else, so that aligned vector loads never straddle two lines.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace rectilin {

/// Allocates memory at multiples of 128 bytes: two cache lines, because some processors fetch lines in pairs.
template <class T>
struct CacheAlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{128};

  CacheAlignedAllocator() = default;
  template <class Other>
  CacheAlignedAllocator(const CacheAlignedAllocator<Other>&) noexcept {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), kAlignment)); }
  void deallocate(T* memory, std::size_t) noexcept { ::operator delete(memory, kAlignment); }

  friend bool operator==(const CacheAlignedAllocator&, const CacheAlignedAllocator&) { return true; }
};

template <class T>
using CacheAligned = std::vector<T, CacheAlignedAllocator<T>>;

}  // namespace rectilin

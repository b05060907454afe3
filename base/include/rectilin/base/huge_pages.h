// Large arrays that are read in no order: on large pages, so that a processor finds its way to a place in them at once.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rectilin {

/// Asks the system for pages of two megabytes, where arrays are that large and the system has such pages. Of a gigabyte
/// in the usual pages of 4 KB, most places take four further reads of memory to find.
template <class T>
struct HugePageAllocator {
  using value_type = T;
  static constexpr std::size_t kPage = std::size_t{2} << 20;

  HugePageAllocator() = default;
  template <class Other>
  HugePageAllocator(const HugePageAllocator<Other>&) noexcept {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < 2 * kPage) return static_cast<T*>(::operator new(bytes));
    void* memory = ::operator new(bytes, std::align_val_t(kPage));
#ifdef __linux__
    madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);  // no harm if it fails
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    if (count * sizeof(T) < 2 * kPage) ::operator delete(memory);
    else ::operator delete(memory, std::align_val_t(kPage));
  }

  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};

template <class T>
using HugePages = std::vector<T, HugePageAllocator<T>>;

}  // namespace rectilin

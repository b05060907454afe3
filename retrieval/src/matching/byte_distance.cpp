// Compiled once for each instruction set: foreach_target.h includes this file again for every one and comes first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "matching/byte_distance.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "matching/byte_distance.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rectilin::retrieval::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

struct RowSum {
  std::uint32_t sum = 0;
  void add(const std::uint8_t* a, const std::uint8_t* b) {
    for (std::size_t i = 0; i < kRow; ++i) sum += static_cast<std::uint32_t>(a[i] < b[i] ? b[i] - a[i] : a[i] - b[i]);
  }
  void add_block(const std::uint8_t* a, const std::uint8_t* b) {
    for (std::size_t i = 0; i < 16; ++i) sum += static_cast<std::uint32_t>(a[i] < b[i] ? b[i] - a[i] : a[i] - b[i]);
  }
  std::uint32_t total() const { return sum; }
};

#else

// Rows of 48 bytes are three blocks of 16: one register of 32 and one of 16 where there are such, else three of 16.
using Small = hn::FixedTag<std::uint8_t, 16>;
using Large = hn::CappedTag<std::uint8_t, 32>;
template <class D>
using Sums = hn::Vec<hn::Repartition<std::uint64_t, D> >;

/// Sums over groups of eight bytes. One of the two differences is cut off at zero, so their union is the absolute one.
template <class D>
HWY_INLINE Sums<D> differences(D d, const std::uint8_t* a, const std::uint8_t* b) {
  const auto x = hn::LoadU(d, a), y = hn::LoadU(d, b);
  return hn::SumsOf8(hn::Or(hn::SaturatedSub(x, y), hn::SaturatedSub(y, x)));
}

/// Sums of rows' differences, not yet added across lanes.
struct RowSum {
  static constexpr bool kWide = HWY_MAX_BYTES >= 32;
  Sums<Small> few;
  Sums<Large> many;

  HWY_INLINE RowSum()
      : few(hn::Zero(hn::Repartition<std::uint64_t, Small>())),
        many(hn::Zero(hn::Repartition<std::uint64_t, Large>())) {}

  HWY_INLINE void add(const std::uint8_t* a, const std::uint8_t* b) {
    if constexpr (kWide) {
      many = hn::Add(many, differences(Large(), a, b));
    } else {
      few = hn::Add(few, hn::Add(differences(Small(), a, b), differences(Small(), a + 16, b + 16)));
    }
    few = hn::Add(few, differences(Small(), a + 32, b + 32));
  }
  HWY_INLINE void add_block(const std::uint8_t* a, const std::uint8_t* b) {
    few = hn::Add(few, differences(Small(), a, b));
  }
  HWY_INLINE std::uint32_t total() const {
    std::uint64_t sum = hn::GetLane(hn::SumOfLanes(hn::Repartition<std::uint64_t, Small>(), few));
    if constexpr (kWide) sum += hn::GetLane(hn::SumOfLanes(hn::Repartition<std::uint64_t, Large>(), many));
    return static_cast<std::uint32_t>(sum);
  }
};

#endif

std::uint32_t least(const std::uint8_t* a, const std::uint8_t* b, std::size_t views, const std::uint16_t* permutations,
                    std::size_t count) {
  std::uint32_t best = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t* p = permutations + i * views;
    RowSum sum;
    for (std::size_t k = 0; k < views; ++k) sum.add(a + k * kRow, b + p[k] * kRow);
    best = std::min(best, sum.total());
  }
  return best;
}

void rows(const std::uint8_t* a, std::size_t count_a, const std::uint8_t* b, std::size_t count_b, std::size_t row,
          std::uint32_t* out) {
  for (std::size_t i = 0; i < count_a; ++i)
    for (std::size_t j = 0; j < count_b; ++j) {
      RowSum sum;
      for (std::size_t k = 0; k < row; k += 16) sum.add_block(a + i * row + k, b + j * row + k);
      out[i * count_b + j] = sum.total();
    }
}

}  // namespace rectilin::retrieval::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin::retrieval {

HWY_EXPORT(least);
HWY_EXPORT(rows);

std::uint32_t least_distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t views,
                             std::span<const std::uint16_t> permutations) {
  return HWY_DYNAMIC_DISPATCH(least)(a, b, views, permutations.data(), permutations.size() / views);
}

void row_distances(const std::uint8_t* a, std::size_t count_a, const std::uint8_t* b, std::size_t count_b,
                   std::size_t row, std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(rows)(a, count_a, b, count_b, row, out);
}

}  // namespace rectilin::retrieval
#endif

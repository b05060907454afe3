// The vector loop that fills the leaves of a direction tree, compiled once for each instruction set. foreach_target.h
// includes this file again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tree/leaf_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "tree/leaf_kernels.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kLeaf>;
using V = hn::Vec<D>;
using D64 = hn::RebindToUnsigned<D>;

/// Writes a component of the vectors `lane` and following of a leaf, as integers in units of 1 / inverse.
HWY_INLINE void store_component(DirectionLeaf& leaf, std::size_t c, std::size_t lane, V v, V inverse) {
  const D d;
  const D64 d64;
  const hn::RebindToSigned<D> whole;
  const V units = hn::Mul(v, inverse);
  const auto rounded = hn::ConvertTo(whole, hn::Add(units, hn::CopySign(hn::Set(d, 0.5), units)));
  const auto most = hn::Set(whole, (std::int64_t{1} << (kLeafBits + 1)) - 1);
  const auto q = hn::BitCast(d64, hn::IfThenElse(hn::Gt(rounded, most), most, rounded));
  const hn::Rebind<std::uint32_t, D> d32;
  const hn::Rebind<std::uint8_t, D> d8;
  const auto high = hn::TruncateTo(d32, hn::ShiftRight<8>(q));
  hn::StoreU(high, d32, reinterpret_cast<std::uint32_t*>(leaf.high[c] + lane));
  hn::StoreU(hn::TruncateTo(d8, q), d8, leaf.low[c] + lane);
}

/// The biased exponents of the units of vectors of this size.
HWY_INLINE hn::Vec<D64> units_of(V largest) {
  const D64 d64;
  const auto exponent = hn::ShiftRight<52>(hn::BitCast(d64, largest));
  const auto least = hn::Set(d64, kLeafBits + 1);
  return hn::Sub(hn::IfThenElse(hn::Gt(least, exponent), least, exponent), hn::Set(d64, kLeafBits));
}

/// Fills a leaf from kLeaf vectors, whose signs change where a bit of `flips` is set.
HWY_INLINE Vector3 fill_leaf(const double* x, const double* y, const double* z, unsigned flips, std::uint64_t unit,
                             DirectionLeaf& leaf) {
  const D d;
  const D64 d64;
  const hn::Rebind<std::uint8_t, D> d8;
  const auto longest = hn::Set(d64, unit), least_inverse = hn::Set(d64, 2046 - unit), most = hn::Set(d64, 255);
  V sum[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(flips >> lane)};
    const V sign = hn::IfThenElseZero(hn::LoadMaskBits(d, bits), hn::SignBit(d));
    const V v[3] = {hn::Xor(hn::LoadU(d, x + lane), sign), hn::Xor(hn::LoadU(d, y + lane), sign),
                    hn::Xor(hn::LoadU(d, z + lane), sign)};
    const V largest = hn::Max(hn::Max(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2]));
    const auto own = units_of(largest);
    const auto below = hn::IfThenElseZero(hn::Gt(longest, own), hn::Sub(longest, own));
    const auto exponent = hn::IfThenElse(hn::Gt(below, most), most, below);
    hn::StoreU(hn::TruncateTo(d8, exponent), d8, leaf.exponent + lane);
    const V inverse = hn::BitCast(d, hn::ShiftLeft<52>(hn::Add(least_inverse, exponent)));
    for (std::size_t c = 0; c < 3; ++c) {
      store_component(leaf, c, lane, v[c], inverse);
      sum[c] = hn::Add(sum[c], v[c]);
    }
  }
  return {hn::GetLane(hn::SumOfLanes(d, sum[0])), hn::GetLane(hn::SumOfLanes(d, sum[1])),
          hn::GetLane(hn::SumOfLanes(d, sum[2]))};
}

/// For each of kLeaf vectors a bit: does it point to the other side than the one before it?
HWY_INLINE unsigned turns(const double* x, const double* y, const double* z) {
  const D d;
  unsigned result = 0;
  for (std::size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    const auto product = [&](const double* c)
                             HWY_ATTR { return hn::Mul(hn::LoadU(d, c + lane), hn::LoadU(d, c + lane - 1)); };
    const V dot = hn::Add(hn::Add(product(x), product(y)), product(z));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Lt(dot, hn::Zero(d)), bits);
    result |= static_cast<unsigned>(bits[0]) << lane;
  }
  return result;
}

void fill(const VectorSpan<double>& run, std::uint64_t unit, DirectionLeaf* leaves, Vector3* sums) {
  // A leaf with the vector before it. The first and the last are copied here, because they have not all neighbours.
  double window[3][1 + kLeaf] = {{0.48}, {0.36}, {0.8}};
  unsigned flipped = 0;  // is the vector before the leaf turned? all bits or none
  std::size_t begin = 0;
  do {  // a run without vectors has a leaf of zeros
    const std::size_t end = std::min(begin + kLeaf, run.size);
    const double* c[3] = {run.x + begin, run.y + begin, run.z + begin};
    if (begin == 0 || end - begin < kLeaf) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (begin > 0) window[k][0] = c[k][-1];
        std::fill(std::copy(c[k], c[k] + (end - begin), window[k] + 1), window[k] + 1 + kLeaf, 0.0);
        c[k] = window[k] + 1;
      }
    }
    unsigned flips = turns(c[0], c[1], c[2]);
    for (const int shift : {1, 2, 4}) flips ^= flips << shift;  // turned against the vector before the leaf
    flips = (flips ^ flipped) & 255;
    flipped = flips >> (kLeaf - 1) ? 255 : 0;
    *sums++ = fill_leaf(c[0], c[1], c[2], flips, unit, *leaves++);
    begin = end;
  } while (begin < run.size);
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(fill);

std::uint64_t leaf_unit(double largest) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largest) >> 52;
  return std::max(exponent, kLeafBits + 1) - kLeafBits;
}

void fill_leaves(const VectorSpan<double>& run, std::uint64_t unit, DirectionLeaf* leaves, Vector3* sums) {
  HWY_DYNAMIC_DISPATCH(fill)(run, unit, leaves, sums);
}

}  // namespace rectilin
#endif

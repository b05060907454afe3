// The vector loop that orders vectors, compiled once for each instruction set. foreach_target.h includes this file again
// for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vectors/cell_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "vectors/cell_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A row of the rotation times vectors. Not fused, so that every instruction set rounds alike.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V product(D d, const std::array<double, 3>& row, V x, V y, V z) {
  return hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y)),
                 hn::Mul(hn::Set(d, row[2]), z));
}

/// The place along the curve of the cell at whole coordinates x, y.
template <class D32, class V32 = hn::Vec<D32>>
HWY_INLINE V32 place_of(D32 d, const CellMap& map, V32 x, V32 y) {
  const V32 low = hn::Set(d, 15), place_bits = hn::Set(d, 255);
  V32 place = hn::Zero(d), orientation = hn::Zero(d);  // the orientation times 256
  const auto descend = [&](V32 right, V32 up) HWY_ATTR {
    const V32 cell = hn::Or(hn::ShiftLeft<4>(hn::And(right, low)), hn::And(up, low));
    const V32 step = hn::GatherIndex(d, map.curve.data(), hn::Or(orientation, cell));
    place = hn::Or(hn::ShiftLeft<8>(place), hn::And(step, place_bits));
    orientation = hn::AndNot(place_bits, step);
  };
  static_assert(CellMap::kBits == 16);
  descend(hn::ShiftRight<12>(x), hn::ShiftRight<12>(y));
  descend(hn::ShiftRight<8>(x), hn::ShiftRight<8>(y));
  descend(hn::ShiftRight<4>(x), hn::ShiftRight<4>(y));
  descend(x, y);
  return place;
}

/// Does the vectors from `begin` on that fill whole registers of D; returns where it stopped.
template <class D>
HWY_INLINE std::size_t some_cells(D d, const CellMap& map, double* vectors, std::size_t begin, std::size_t end,
                                  std::uint64_t* items, SizeRange& range) {
  using V = hn::Vec<D>;
  const hn::RebindToUnsigned<D> d64;
  const hn::Rebind<std::int32_t, D> whole;
  const hn::Rebind<std::uint32_t, D> d32;
  const V zero = hn::Zero(d), shortest = hn::Set(d, 1e-300);  // what is shorter weighs nothing
  constexpr double kHalf = 1 << (CellMap::kBits - 1);
  const V half = hn::Set(d, kHalf), last = hn::Set(d, 2 * kHalf - 1);
  const V most = hn::Set(d, SizeRange::kMost);
  V largest = zero;
  auto none_above = hn::Eq(zero, zero);
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes) {
    V x, y, z;
    hn::LoadInterleaved3(d, vectors + 3 * i, x, y, z);
    const V height = product(d, map.rows[2], x, y, z);
    const V sign = hn::IfThenElseZero(hn::Lt(height, zero), hn::SignBit(d));
    x = hn::Xor(x, sign), y = hn::Xor(y, sign), z = hn::Xor(z, sign);
    hn::StoreInterleaved3(x, y, z, d, vectors + 3 * i);

    // The hemisphere becomes a square by the hemi-octahedral projection (Cigolle et al. 2014).
    const V a = product(d, map.rows[0], x, y, z), b = product(d, map.rows[1], x, y, z);
    const V norm = hn::Add(hn::Add(hn::Abs(a), hn::Abs(b)), hn::Abs(height));
    const V scale = hn::Div(half, hn::Max(norm, shortest));
    const auto quantised = [&](V c) HWY_ATTR {  // from [-norm, norm]
      return hn::DemoteTo(whole, hn::Min(hn::Max(hn::Add(hn::Mul(c, scale), half), zero), last));
    };
    const auto place = hn::BitCast(d32, place_of(whole, map, quantised(hn::Add(a, b)), quantised(hn::Sub(a, b))));
    const auto item = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(d64, place)), hn::Iota(d64, i));
    const V size = hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
    none_above = hn::And(none_above, hn::Le(size, most));
    largest = hn::Max(largest, size);
    const auto absent = hn::RebindMask(d64, hn::Eq(size, zero));
    hn::StoreU(hn::IfThenElse(absent, hn::Set(d64, kDropped), item), d64, items + i);
  }
  range.none_above &= hn::AllTrue(d, none_above);
  range.some_counts |= hn::GetLane(hn::MaxOfLanes(d, largest)) >= SizeRange::kLeast;
  return i;
}

SizeRange all_cells(const CellMap& map, double* vectors, std::size_t begin, std::size_t end, std::uint64_t* items) {
  SizeRange range;
  const std::size_t rest = some_cells(hn::ScalableTag<double>(), map, vectors, begin, end, items, range);
  some_cells(hn::CappedTag<double, 1>(), map, vectors, rest, end, items, range);
  return range;
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(all_cells);

SizeRange find_cells(const CellMap& map, double* vectors, std::size_t begin, std::size_t end, std::uint64_t* items) {
  return HWY_DYNAMIC_DISPATCH(all_cells)(map, vectors, begin, end, items);
}

}  // namespace rectilin
#endif

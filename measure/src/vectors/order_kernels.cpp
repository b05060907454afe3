// The vector loops that order vectors, compiled once for each instruction set. foreach_target.h includes this file
// again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vectors/order_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "vectors/order_kernels.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Rows = std::array<std::array<double, 3>, 3>;

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
  return hn::Or(hn::ShiftLeft<16>(place), hn::Or(hn::ShiftLeft<8>(hn::And(x, place_bits)), hn::And(y, place_bits)));
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
  auto indices = hn::Iota(d64, begin);  // counted up: making it anew goes through memory
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
    const auto item = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(d64, place)), indices);
    indices = hn::Add(indices, hn::Set(d64, lanes));
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

struct Limits {
  float least = std::numeric_limits<float>::max(), greatest = std::numeric_limits<float>::lowest();
};

/// Projects the vectors from `begin` on that fill whole registers of D; returns where it stopped.
template <class D>
HWY_INLINE std::size_t project_some(D d, const VectorSpan<double>& run, std::size_t begin, const Rows& rows,
                                    float* across, float* up, Limits* limits) {
  using V = hn::Vec<D>;
  const hn::Rebind<float, D> single;
  const V one = hn::Set(d, 1.0), shortest = hn::Set(d, std::numeric_limits<double>::min());
  hn::Vec<decltype(single)> least[2], greatest[2];
  for (int k = 0; k < 2; ++k) {
    least[k] = hn::Set(single, limits[k].least);
    greatest[k] = hn::Set(single, limits[k].greatest);
  }
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = begin;
  for (; i + lanes <= run.size; i += lanes) {
    const V x = hn::LoadU(d, run.x + i), y = hn::LoadU(d, run.y + i), z = hn::LoadU(d, run.z + i);
    const V height = product(d, rows[2], x, y, z);
    const V norm = hn::Sqrt(hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z)));
    const V size = hn::Add(norm, hn::Abs(height));
    const V inverse =
        hn::IfThenElseZero(hn::Ge(size, shortest), hn::CopySign(hn::Div(one, hn::Max(size, shortest)), height));
    const auto a = hn::DemoteTo(single, hn::Mul(product(d, rows[0], x, y, z), inverse));
    const auto b = hn::DemoteTo(single, hn::Mul(product(d, rows[1], x, y, z), inverse));
    hn::StoreU(a, single, across + i);
    hn::StoreU(b, single, up + i);
    least[0] = hn::Min(least[0], a), greatest[0] = hn::Max(greatest[0], a);
    least[1] = hn::Min(least[1], b), greatest[1] = hn::Max(greatest[1], b);
  }
  for (int k = 0; k < 2; ++k) {
    limits[k].least = hn::GetLane(hn::MinOfLanes(single, least[k]));
    limits[k].greatest = hn::GetLane(hn::MaxOfLanes(single, greatest[k]));
  }
  return i;
}

void project_all(const VectorSpan<double>& run, const Rows& rows, float* across, float* up, std::uint16_t* whole_across,
                 std::uint16_t* whole_up) {
  Limits limits[2];
  const std::size_t rest = project_some(hn::ScalableTag<double>(), run, 0, rows, across, up, limits);
  project_some(hn::CappedTag<double, 1>(), run, rest, rows, across, up, limits);
  const float extent = std::max(
      {limits[0].greatest - limits[0].least, limits[1].greatest - limits[1].least, std::numeric_limits<float>::min()});
  for (std::size_t i = 0; i < run.size; ++i) {
    whole_across[i] =
        static_cast<std::uint16_t>(static_cast<std::int32_t>((across[i] - limits[0].least) / extent * 65535));
    whole_up[i] = static_cast<std::uint16_t>(static_cast<std::int32_t>((up[i] - limits[1].least) / extent * 65535));
  }
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(all_cells);
HWY_EXPORT(project_all);

SizeRange find_cells(const CellMap& map, double* vectors, std::size_t begin, std::size_t end, std::uint64_t* items) {
  return HWY_DYNAMIC_DISPATCH(all_cells)(map, vectors, begin, end, items);
}

void project(const VectorSpan<double>& run, const std::array<std::array<double, 3>, 3>& rows, float* across, float* up,
             std::uint16_t* whole_across, std::uint16_t* whole_up) {
  HWY_DYNAMIC_DISPATCH(project_all)(run, rows, across, up, whole_across, whole_up);
}

}  // namespace rectilin
#endif

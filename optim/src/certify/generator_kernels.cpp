// foreach_target.h includes this file again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/generator_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "certify/generator_kernels.h"

#include <algorithm>
#include <bit>

#include "certify/store_chosen-inl.h"

#ifndef RECTILIN_SPLIT_BLOCK
#define RECTILIN_SPLIT_BLOCK
namespace rectilin::certification {

/// Sums are added up in registers over this many generators, and then in extended precision.
inline constexpr std::size_t kSplitBlock = 4096;
using BlockSums = std::array<long double, 10>;

}  // namespace rectilin::certification
#endif

HWY_BEFORE_NAMESPACE();
namespace rectilin::certification::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, kGeneratorLanes>;
using V = hn::Vec<Tag>;

struct Direction {
  V x, y, z;

  HWY_INLINE explicit Direction(const Eigen::Vector3d& u)
      : x(hn::Set(Tag(), u[0])), y(hn::Set(Tag(), u[1])), z(hn::Set(Tag(), u[2])) {}
  HWY_INLINE V dot(V a, V b, V c) const { return hn::MulAdd(z, c, hn::MulAdd(y, b, hn::Mul(x, a))); }
};

HWY_INLINE double sum_of_lanes(V v) { return hn::GetLane(hn::SumOfLanes(Tag(), v)); }

Eigen::Vector3d signed_sum(const GeneratorSpan& g, const Eigen::Vector3d& u) {
  const Tag d;
  const Direction direction(u);
  const V sign_bit = hn::Set(d, -0.0);
  V x = hn::Zero(d), y = hn::Zero(d), z = hn::Zero(d);
  for (std::size_t i = 0; i < g.size; i += hn::Lanes(d)) {
    const V a = hn::LoadU(d, g.x + i), b = hn::LoadU(d, g.y + i), c = hn::LoadU(d, g.z + i);
    const V sign = hn::And(direction.dot(a, b, c), sign_bit);
    x = hn::Add(x, hn::Xor(a, sign));
    y = hn::Add(y, hn::Xor(b, sign));
    z = hn::Add(z, hn::Xor(c, sign));
  }
  return {sum_of_lanes(x), sum_of_lanes(y), sum_of_lanes(z)};
}

std::size_t copy_unsettled(const GeneratorSpan& generators, const Triangle3& corners, const GeneratorOutput& output,
                           Eigen::Vector3d& settled) {
  const Tag d;
  const GeneratorSpan g = generators;  // copies, which stores of vectors cannot change
  const GeneratorOutput out = output;
  const Direction p(corners[0]), q(corners[1]), r(corners[2]);
  const V zero = hn::Zero(d), sign_bit = hn::Set(d, -0.0);
  V x = zero, y = zero, z = zero;
  std::size_t count = 0;
  for (std::size_t i = 0; i < g.size; i += hn::Lanes(d)) {
    const V a = hn::LoadU(d, g.x + i), b = hn::LoadU(d, g.y + i), c = hn::LoadU(d, g.z + i);
    const V at_p = p.dot(a, b, c), at_q = q.dot(a, b, c), at_r = r.dot(a, b, c);
    const V least = hn::Min(at_p, hn::Min(at_q, at_r)), most = hn::Max(at_p, hn::Max(at_q, at_r));
    const auto below = hn::Lt(least, zero), mixed = hn::And(below, hn::Gt(most, zero));
    const V sign = hn::IfThenElseZero(below, sign_bit);  // not the sign of `least` itself, which may be -0
    x = hn::Add(x, hn::IfThenZeroElse(mixed, hn::Xor(a, sign)));
    y = hn::Add(y, hn::IfThenZeroElse(mixed, hn::Xor(b, sign)));
    z = hn::Add(z, hn::IfThenZeroElse(mixed, hn::Xor(c, sign)));
    if (hn::AllFalse(d, mixed)) continue;
    store_chosen(d, a, mixed, out.x + count);
    store_chosen(d, b, mixed, out.y + count);
    store_chosen(d, c, mixed, out.z + count);
    count += hn::CountTrue(d, mixed);
  }
  settled += Eigen::Vector3d(sum_of_lanes(x), sum_of_lanes(y), sum_of_lanes(z));
  return count;
}

/// Writes the places of the near generators to `near` and returns their number. Adds to `sums` three components for
/// each axis, and the total.
std::size_t split_block(const GeneratorSpan& g, const Eigen::Matrix3d& frame, double sine, std::uint32_t* near,
                        BlockSums& sums) {
  const Tag d;
  const V zero = hn::Zero(d), sign_bit = hn::Set(d, -0.0), factor = hn::Set(d, sine);
  const Direction axes[3] = {Direction(frame.row(0)), Direction(frame.row(1)), Direction(frame.row(2))};
  V sum[9] = {zero, zero, zero, zero, zero, zero, zero, zero, zero}, total = zero;
  std::size_t count = 0;
  for (std::size_t i = 0; i < g.size; i += hn::Lanes(d)) {
    const V a = hn::LoadU(d, g.x + i), b = hn::LoadU(d, g.y + i), c = hn::LoadU(d, g.z + i);
    const V length = hn::Sqrt(hn::MulAdd(a, a, hn::MulAdd(b, b, hn::Mul(c, c)))), limit = hn::Mul(factor, length);
    const V at[3] = {axes[0].dot(a, b, c), axes[1].dot(a, b, c), axes[2].dot(a, b, c)};
    const V least = hn::Min(hn::Abs(at[0]), hn::Min(hn::Abs(at[1]), hn::Abs(at[2])));
    const auto close = hn::Lt(least, limit);
    const V x = hn::IfThenZeroElse(close, a), y = hn::IfThenZeroElse(close, b), z = hn::IfThenZeroElse(close, c);
    for (int k = 0; k < 3; ++k) {
      const V sign = hn::And(at[k], sign_bit);
      sum[3 * k] = hn::Add(sum[3 * k], hn::Xor(x, sign));
      sum[3 * k + 1] = hn::Add(sum[3 * k + 1], hn::Xor(y, sign));
      sum[3 * k + 2] = hn::Add(sum[3 * k + 2], hn::Xor(z, sign));
    }
    total = hn::Add(total, length);
    if (hn::AllFalse(d, close)) continue;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, close, bits);
    for (unsigned rest = bits[0]; rest != 0; rest &= rest - 1)
      near[count++] = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(std::countr_zero(rest));
  }
  for (int i = 0; i < 9; ++i) sums[i] += sum_of_lanes(sum[i]);
  sums[9] += sum_of_lanes(total);
  return count;
}

}  // namespace
}  // namespace rectilin::certification::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin::certification {

HWY_EXPORT(signed_sum);
HWY_EXPORT(copy_unsettled);
HWY_EXPORT(split_block);

Eigen::Vector3d signed_sum(const GeneratorSpan& generators, const Eigen::Vector3d& u) {
  return HWY_DYNAMIC_DISPATCH(signed_sum)(generators, u);
}

std::size_t copy_unsettled(const GeneratorSpan& generators, const Triangle3& corners, const GeneratorOutput& out,
                           Eigen::Vector3d& settled) {
  return HWY_DYNAMIC_DISPATCH(copy_unsettled)(generators, corners, out, settled);
}

FrameSplit split_at(const Eigen::Matrix3d& frame, const Generators& generators, double sine) {
  FrameSplit split;
  BlockSums sums = {};
  const auto add_block = [&](const GeneratorSpan& block, std::size_t begin) {
    std::array<std::uint32_t, kSplitBlock> near;
    const std::size_t count = HWY_DYNAMIC_DISPATCH(split_block)(block, frame, sine, near.data(), sums);
    for (std::size_t i = 0; i < count; ++i) split.near.push_back(begin + near[i]);
  };
  const std::size_t size = generators.size(), whole = size / kGeneratorLanes * kGeneratorLanes;
  const std::span<const double> x = generators.x, y = generators.y, z = generators.z;
  for (std::size_t begin = 0; begin < whole; begin += kSplitBlock)
    add_block({&x[begin], &y[begin], &z[begin], std::min(kSplitBlock, whole - begin)}, begin);
  std::array<std::array<double, kGeneratorLanes>, 3> tail = {};
  std::copy(x.begin() + whole, x.end(), tail[0].begin());
  std::copy(y.begin() + whole, y.end(), tail[1].begin());
  std::copy(z.begin() + whole, z.end(), tail[2].begin());
  add_block({tail[0].data(), tail[1].data(), tail[2].data(), kGeneratorLanes}, whole);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) split.others[k][i] = generators.scale * sums[3 * k + i];
  split.total = static_cast<double>(generators.scale * sums[9]);
  return split;
}

}  // namespace rectilin::certification
#endif

// foreach_target.h includes this file again for every instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/generator_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "certify/generator_kernels.h"

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

std::size_t copy_unsettled(const GeneratorSpan& g, const Triangle3& corners, const GeneratorOutput& out,
                           Eigen::Vector3d& settled) {
  const Tag d;
  const Direction p(corners[0]), q(corners[1]), r(corners[2]);
  const V zero = hn::Zero(d), sign_bit = hn::Set(d, -0.0);
  V x = zero, y = zero, z = zero;
  std::size_t count = 0;
  for (std::size_t i = 0; i < g.size; i += hn::Lanes(d)) {
    const V a = hn::LoadU(d, g.x + i), b = hn::LoadU(d, g.y + i), c = hn::LoadU(d, g.z + i);
    const V at_p = p.dot(a, b, c), at_q = q.dot(a, b, c), at_r = r.dot(a, b, c);
    const V least = hn::Min(at_p, hn::Min(at_q, at_r)), most = hn::Max(at_p, hn::Max(at_q, at_r));
    const auto below = hn::Lt(least, zero), mixed = hn::And(below, hn::Gt(most, zero));
    const V sign = hn::IfThenElseZero(below, sign_bit);  // not the bit of `least`, which may be -0
    x = hn::Add(x, hn::IfThenZeroElse(mixed, hn::Xor(a, sign)));
    y = hn::Add(y, hn::IfThenZeroElse(mixed, hn::Xor(b, sign)));
    z = hn::Add(z, hn::IfThenZeroElse(mixed, hn::Xor(c, sign)));
    if (hn::AllFalse(d, mixed)) continue;
    hn::CompressStore(b, mixed, d, out.y + count);
    hn::CompressStore(c, mixed, d, out.z + count);
    count += hn::CompressStore(a, mixed, d, out.x + count);
  }
  settled += Eigen::Vector3d(sum_of_lanes(x), sum_of_lanes(y), sum_of_lanes(z));
  return count;
}

}  // namespace
}  // namespace rectilin::certification::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin::certification {

HWY_EXPORT(signed_sum);
HWY_EXPORT(copy_unsettled);

Eigen::Vector3d signed_sum(const GeneratorSpan& generators, const Eigen::Vector3d& u) {
  return HWY_DYNAMIC_DISPATCH(signed_sum)(generators, u);
}

std::size_t copy_unsettled(const GeneratorSpan& generators, const Triangle3& corners, const GeneratorOutput& out,
                           Eigen::Vector3d& settled) {
  return HWY_DYNAMIC_DISPATCH(copy_unsettled)(generators, corners, out, settled);
}

}  // namespace rectilin::certification
#endif

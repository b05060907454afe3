// How far vectors in registers are from an axis; for sums that skip what lies on one side of a great circle. Compiled
// once for each instruction set, hence Highway's special include guard.
#if defined(RECTILIN_CAP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RECTILIN_CAP_INL_H
#undef RECTILIN_CAP_INL_H
#else
#define RECTILIN_CAP_INL_H
#endif

#include <limits>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V squared_length(V x, V y, V z) {
  return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
}

/// The squared sines of the angles between a unit vector and vectors: zero for the zero vector, infinite if an angle is
/// not acute, or if a vector is too short to tell.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V squared_sine(D d, V x, V y, V z, V ax, V ay, V az) {
  const V zero = hn::Zero(d), infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  const V shortest = hn::Set(d, 1e-280);  // least squared length that has lost no digits to underflow
  const V length = squared_length(x, y, z);
  const V cross = squared_length(hn::MulSub(y, az, hn::Mul(z, ay)), hn::MulSub(z, ax, hn::Mul(x, az)),
                                 hn::MulSub(x, ay, hn::Mul(y, ax)));
  const V dot = hn::MulAdd(x, ax, hn::MulAdd(y, ay, hn::Mul(z, az)));
  const auto clear = hn::And(hn::Gt(dot, zero), hn::Gt(length, shortest));
  const auto absent = hn::Eq(hn::Max(hn::Abs(x), hn::Max(hn::Abs(y), hn::Abs(z))), zero);
  return hn::IfThenZeroElse(absent, hn::IfThenElse(clear, hn::Div(cross, length), infinity));
}

}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// The vector loop of the smooth surrogate, compiled once for each instruction set. foreach_target.h includes this file
// again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "objective/smooth_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "objective/smooth_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Prevents 0/0 for vectors so short that their squares vanish. Its root is far below the last digit of any sum.
constexpr double kLeast = 0x1p-1000;

/// Adds the vectors from `begin` on that fill whole registers of D; returns where it stopped.
template <class D>
HWY_INLINE std::size_t add_faces(D d, const VectorSpan<double>& faces, std::size_t begin, const Eigen::Matrix3d& frame,
                                 double width, SmoothSums& sums) {
  using V = hn::Vec<D>;
  V value = hn::Zero(d), gradient[3][3], r[3][3];
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) gradient[k][c] = hn::Zero(d), r[k][c] = hn::Set(d, frame(k, c));
  const V square_of_width = hn::Set(d, width * width), least = hn::Set(d, kLeast);
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = begin;
  for (; i + lanes <= faces.size; i += lanes) {
    const V v[3] = {hn::LoadU(d, faces.x + i), hn::LoadU(d, faces.y + i), hn::LoadU(d, faces.z + i)};
    const V square = hn::MulAdd(v[0], v[0], hn::MulAdd(v[1], v[1], hn::Mul(v[2], v[2])));
    const V softening = hn::MulAdd(square_of_width, square, least);
    for (int k = 0; k < 3; ++k) {
      const V along = hn::MulAdd(r[k][0], v[0], hn::MulAdd(r[k][1], v[1], hn::Mul(r[k][2], v[2])));
      const V rounded = hn::Sqrt(hn::MulAdd(along, along, softening));
      const V slope = hn::Div(along, rounded);
      value = hn::Add(value, rounded);
      for (int c = 0; c < 3; ++c) gradient[k][c] = hn::MulAdd(slope, v[c], gradient[k][c]);
    }
  }
  sums.value += hn::GetLane(hn::SumOfLanes(d, value));
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) sums.gradient(k, c) += hn::GetLane(hn::SumOfLanes(d, gradient[k][c]));
  return i;
}

SmoothSums sums_of(const VectorSpan<double>& faces, const Eigen::Matrix3d& frame, double width) {
  SmoothSums sums;
  const std::size_t rest = add_faces(hn::ScalableTag<double>(), faces, 0, frame, width, sums);
  add_faces(hn::CappedTag<double, 1>(), faces, rest, frame, width, sums);
  return sums;
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(sums_of);

SmoothSums smooth_sums(const VectorSpan<double>& faces, const Eigen::Matrix3d& frame, double width) {
  return HWY_DYNAMIC_DISPATCH(sums_of)(faces, frame, width);
}

}  // namespace rectilin
#endif

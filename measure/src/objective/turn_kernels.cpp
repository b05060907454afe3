// The vector loop of the best turn, compiled once for each instruction set. foreach_target.h includes this file again
// for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "objective/turn_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "objective/turn_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Views the vectors from `begin` on that fill whole registers of D; returns where it stopped.
template <class D>
HWY_INLINE std::size_t view_some(D d, const VectorSpan<double>& faces, std::size_t begin, const QuadrantView& view,
                                 double* x, double* y, std::int32_t* bucket) {
  using V = hn::Vec<D>;
  V p[3], q[3];
  for (int c = 0; c < 3; ++c) p[c] = hn::Set(d, view.first[c]), q[c] = hn::Set(d, -view.second[c]);
  const V buckets = hn::Set(d, view.buckets), last = hn::Set(d, view.buckets - 1);
  const V zero = hn::Zero(d), least = hn::Set(d, QuadrantView::kLeast);
  const hn::Rebind<std::int32_t, D> whole;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = begin;
  for (; i + lanes <= faces.size; i += lanes) {
    const V vx = hn::LoadU(d, faces.x + i), vy = hn::LoadU(d, faces.y + i), vz = hn::LoadU(d, faces.z + i);
    const V a = hn::MulAdd(p[0], vx, hn::MulAdd(p[1], vy, hn::Mul(p[2], vz)));
    const V b = hn::MulAdd(q[0], vx, hn::MulAdd(q[1], vy, hn::Mul(q[2], vz)));
    // A half turn changes both signs; a quarter turn moves what is in the second quadrant to the first.
    const auto second_quadrant = hn::Xor(hn::Lt(a, zero), hn::Lt(b, zero));
    const V across = hn::IfThenElse(second_quadrant, hn::Abs(b), hn::Abs(a));
    const V up = hn::IfThenElse(second_quadrant, hn::Abs(a), hn::Abs(b));
    const V place = hn::Div(up, hn::Max(hn::Add(across, up), least));
    hn::StoreU(across, d, x + i);
    hn::StoreU(up, d, y + i);
    hn::StoreU(hn::DemoteTo(whole, hn::Min(hn::Mul(place, buckets), last)), whole, bucket + i);
  }
  return i;
}

void view_all(const VectorSpan<double>& faces, const QuadrantView& view, double* x, double* y, std::int32_t* bucket) {
  const std::size_t rest = view_some(hn::ScalableTag<double>(), faces, 0, view, x, y, bucket);
  view_some(hn::CappedTag<double, 1>(), faces, rest, view, x, y, bucket);
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(view_all);

void view_vectors(const VectorSpan<double>& faces, const QuadrantView& view, double* x, double* y,
                  std::int32_t* bucket) {
  HWY_DYNAMIC_DISPATCH(view_all)(faces, view, x, y, bucket);
}

}  // namespace rectilin
#endif

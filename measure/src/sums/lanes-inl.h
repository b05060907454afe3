// Running sums in vector registers, which the flat sum and the direction tree share. Compiled once for each instruction
// set, hence Highway's special include guard.
#if defined(RECTILIN_FLAT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RECTILIN_FLAT_LANES_INL_H
#undef RECTILIN_FLAT_LANES_INL_H
#else
#define RECTILIN_FLAT_LANES_INL_H
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE double lane_sum(D d, hn::Vec<D> v) {
  return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, v)));
}

/// sum + v in the lanes of `mask`: a single instruction where there are mask registers (AVX-512), otherwise one more
/// than the addition.
template <class D>
HWY_INLINE hn::Vec<D> add_if(D, hn::Mask<D> mask, hn::Vec<D> sum, hn::Vec<D> v) {
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(mask, hn::Add(sum, v), sum);
#else
  return hn::Add(sum, hn::IfThenElseZero(mask, v));
#endif
}

/// Adds to a sum that is kept in memory, lane by lane.
template <class D>
HWY_INLINE void add_lanes(D d, hn::Vec<D> v, hn::TFromD<D>* lanes) {
  hn::Store(hn::Add(hn::Load(d, lanes), v), d, lanes);
}

// The sums are named members: compilers keep these in registers, but often not the elements of an array.

/// sum min(s, 0)
template <class D>
struct NegativePart {
  using V = hn::Vec<D>;
  static constexpr int kOutputs = 1;
  V sum;

  HWY_INLINE NegativePart()
      : sum(hn::Zero(D())) {}  // written out: an implicit constructor would not get the instruction set
  HWY_INLINE void add(V, V, V, V s) { sum = hn::Add(sum, hn::Min(s, hn::Zero(D()))); }
  HWY_INLINE void add_to(double* out) const { out[0] += lane_sum(D(), sum); }
  HWY_INLINE void add_to_lanes(hn::TFromD<D>* lanes) const { add_lanes(D(), sum, lanes); }
};

/// sum of v
template <class D>
struct TotalSum {
  using V = hn::Vec<D>;
  static constexpr int kOutputs = 3;
  V x, y, z;

  HWY_INLINE TotalSum() : x(hn::Zero(D())), y(x), z(x) {}

  HWY_INLINE void add(V vx, V vy, V vz, V) {
    x = hn::Add(x, vx);
    y = hn::Add(y, vy);
    z = hn::Add(z, vz);
  }
  HWY_INLINE void add_to(double* out) const {
    out[0] += lane_sum(D(), x);
    out[1] += lane_sum(D(), y);
    out[2] += lane_sum(D(), z);
  }
  HWY_INLINE void add_to_lanes(hn::TFromD<D>* lanes) const {
    const D d;
    add_lanes(d, x, lanes);
    add_lanes(d, y, lanes + hn::Lanes(d));
    add_lanes(d, z, lanes + 2 * hn::Lanes(d));
  }
};

/// sum of v where s < 0
template <class D>
struct NegativeSum : TotalSum<D> {
  using V = hn::Vec<D>;

  HWY_INLINE NegativeSum() {}
  HWY_INLINE void add(V vx, V vy, V vz, V s) {
    const D d;
    const auto negative = hn::Lt(s, hn::Zero(d));
    this->x = add_if(d, negative, this->x, vx);
    this->y = add_if(d, negative, this->y, vy);
    this->z = add_if(d, negative, this->z, vz);
  }
};

}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

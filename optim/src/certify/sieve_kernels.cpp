// foreach_target.h includes this file again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/sieve_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "certify/sieve_kernels.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace rectilin::certification::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes8 = hn::CappedTag<double, CutTable::kLanes>;  // the eight go through registers of 2, 4 or 8 lanes
using V8 = hn::Vec<Lanes8>;

HWY_INLINE V8 all(double value) { return hn::Set(Lanes8(), value); }

void add_rivals(const CutTable::Block& block, const Eigen::Vector3d& known, const Eigen::Vector3d& middle, double reach,
                CutList& rivals) {
  const Lanes8 d;
  const V8 kx = all(known[0]), ky = all(known[1]), kz = all(known[2]);
  const V8 mx = all(middle[0]), my = all(middle[1]), mz = all(middle[2]);
  for (std::size_t i = 0; i < CutTable::kLanes; i += hn::Lanes(d)) {
    const V8 gx = hn::LoadU(d, block.row[0].data() + i), gy = hn::LoadU(d, block.row[1].data() + i),
             gz = hn::LoadU(d, block.row[2].data() + i);
    const V8 x = hn::Sub(gx, kx), y = hn::Sub(gy, ky), z = hn::Sub(gz, kz);
    const V8 lead = hn::MulAdd(z, mz, hn::MulAdd(y, my, hn::Mul(x, mx)));
    const V8 squared = hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x)));
    const auto may_win =
        hn::Or(hn::Gt(lead, hn::Zero(d)), hn::Lt(hn::Mul(lead, lead), hn::Mul(squared, all(reach * reach))));
    if (hn::AllFalse(d, may_win)) continue;
    hn::CompressStore(gx, may_win, d, rivals.x.data() + rivals.size);
    hn::CompressStore(gy, may_win, d, rivals.y.data() + rivals.size);
    rivals.size += hn::CompressStore(gz, may_win, d, rivals.z.data() + rivals.size);
    rivals.size = std::min(rivals.size, CutList::kMost);
  }
}

/// Vectors, one in each lane.
struct Vectors {
  V8 x, y, z;
};

/// For each vector the cut that is greatest there.
HWY_INLINE Vectors greatest(const CutList& cuts, const Vectors& at) {
  V8 best = all(-1e300);
  Vectors g = {best, best, best};
  for (std::size_t j = 0; j < cuts.size; ++j) {
    const V8 x = all(cuts.x[j]), y = all(cuts.y[j]), z = all(cuts.z[j]);
    const V8 value = hn::MulAdd(z, at.z, hn::MulAdd(y, at.y, hn::Mul(x, at.x)));
    const auto better = hn::Gt(value, best);
    best = hn::Max(best, value);
    g.x = hn::IfThenElse(better, x, g.x);
    g.y = hn::IfThenElse(better, y, g.y);
    g.z = hn::IfThenElse(better, z, g.z);
  }
  return g;
}

Octants test_octants(const Box& box, const std::array<CutList, 3>& lists, double enough) {
  const Lanes8 d;
  const V8 zero = hn::Zero(d), one = all(1), two = all(2);
  Octants octants;
  for (std::size_t first = 0; first < 8; first += hn::Lanes(d)) {
    // The octants have the middles c and half the edges of the box.
    V8 c[3], e[3], beyond = zero;
    for (int i = 0; i < 3; ++i) {
      const double quarter = 0.25 * (box.upper[i] - box.lower[i]);
      e[i] = all(quarter);
      c[i] = hn::MulAdd(hn::LoadU(d, kCornerSigns[i].data() + first), e[i], all(0.5 * (box.lower[i] + box.upper[i])));
      beyond = hn::Add(beyond, hn::Max(hn::Sub(hn::Abs(c[i]), e[i]), zero));
    }
    // The rows of the rotations at the middles, times 1 + |c|^2: what is greatest does not depend on their length.
    const V8 xx = hn::Mul(c[0], c[0]), yy = hn::Mul(c[1], c[1]), zz = hn::Mul(c[2], c[2]);
    const V8 xy = hn::Mul(c[0], c[1]), xz = hn::Mul(c[0], c[2]), yz = hn::Mul(c[1], c[2]);
    const auto twice_sum = [&](V8 a, V8 b) { return hn::Mul(two, hn::Add(a, b)); };
    const auto twice_less = [&](V8 a, V8 b) { return hn::Mul(two, hn::Sub(a, b)); };
    const auto diagonal = [&](V8 a, V8 b, V8 sum) { return hn::Sub(hn::Add(one, a), hn::Add(b, sum)); };
    const Vectors g0 = greatest(lists[0], {diagonal(xx, yy, zz), twice_less(xy, c[2]), twice_sum(xz, c[1])});
    const Vectors g1 = greatest(lists[1], {twice_sum(xy, c[2]), diagonal(yy, xx, zz), twice_less(yz, c[0])});
    const Vectors g2 = greatest(lists[2], {twice_less(xz, c[1]), twice_sum(yz, c[0]), diagonal(zz, xx, yy)});

    // f(rho) = (1 + |rho|^2) (<G, R> - enough) = t + 2 w . rho + rho . M rho, and lemma 1 for it.
    const V8 trace = hn::Add(hn::Add(g0.x, g1.y), g2.z), t = hn::Sub(trace, all(enough));
    const V8 w[3] = {hn::Sub(g2.y, g1.z), hn::Sub(g0.z, g2.x), hn::Sub(g1.x, g0.y)};
    const V8 lower = hn::Add(trace, all(enough));
    const V8 m0 = hn::Sub(hn::Mul(two, g0.x), lower), m1 = hn::Sub(hn::Mul(two, g1.y), lower),
             m2 = hn::Sub(hn::Mul(two, g2.z), lower);
    const V8 m01 = hn::Add(g0.y, g1.x), m02 = hn::Add(g0.z, g2.x), m12 = hn::Add(g1.z, g2.y);
    const auto half_slope = [&](V8 wi, V8 a, V8 b, V8 c3) {
      return hn::Add(wi, hn::MulAdd(a, c[0], hn::MulAdd(b, c[1], hn::Mul(c3, c[2]))));
    };
    const V8 b0 = half_slope(w[0], m0, m01, m02), b1 = half_slope(w[1], m01, m1, m12),
             b2 = half_slope(w[2], m02, m12, m2);
    V8 f = t, cost = zero;  // at the middle, and what moving to a corner costs by curvature
    const V8 slopes[3] = {b0, b1, b2}, curvatures[3] = {m0, m1, m2};
    for (int i = 0; i < 3; ++i) {
      f = hn::MulAdd(hn::Add(w[i], slopes[i]), c[i], f);
      cost = hn::MulAdd(hn::Min(curvatures[i], zero), hn::Mul(e[i], e[i]), cost);
    }
    hn::StoreU(hn::Add(all(enough), hn::Div(f, hn::Add(one, hn::Add(xx, hn::Add(yy, zz))))), d,
               octants.value.data() + first);
    // The least of s . B + sum of s_i s_j C_ij over signs s; the third sign is the one that makes its factor negative.
    const V8 p0 = hn::Mul(two, hn::Mul(b0, e[0])), p1 = hn::Mul(two, hn::Mul(b1, e[1])),
             p2 = hn::Mul(two, hn::Mul(b2, e[2]));
    const V8 q01 = hn::Mul(two, hn::Mul(m01, hn::Mul(e[0], e[1]))),
             q02 = hn::Mul(two, hn::Mul(m02, hn::Mul(e[0], e[2]))),
             q12 = hn::Mul(two, hn::Mul(m12, hn::Mul(e[1], e[2])));
    const V8 sum = hn::Add(p0, p1), less = hn::Sub(p0, p1), along = hn::Add(q02, q12), across = hn::Sub(q02, q12);
    const auto both = [&](V8 rest, V8 last) {  // the least for a choice of the first two signs and for its opposite
      return hn::Min(hn::Sub(rest, hn::Abs(hn::Add(p2, last))), hn::Sub(hn::Neg(rest), hn::Abs(hn::Sub(p2, last))));
    };
    const V8 least = hn::Min(hn::Add(both(sum, along), q01), hn::Sub(both(less, across), q01));
    const V8 bound = hn::Add(hn::Add(f, cost), least);
    hn::StoreU(hn::Add(all(enough), bound), d, octants.bound.data() + first);
    const auto settled = hn::Or(hn::Ge(bound, zero), hn::Gt(beyond, all(1 + 1e-12)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Not(settled), bits);
    octants.open |= (bits[0] & ((1u << hn::Lanes(d)) - 1)) << first;
  }
  return octants;
}

}  // namespace
}  // namespace rectilin::certification::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin::certification {

HWY_EXPORT(add_rivals);
HWY_EXPORT(test_octants);

void add_rivals(const CutTable::Block& block, const Eigen::Vector3d& known, const Eigen::Vector3d& middle, double reach,
                CutList& rivals) {
  HWY_DYNAMIC_DISPATCH(add_rivals)(block, known, middle, reach, rivals);
}

Octants test_octants(const Box& box, const std::array<CutList, 3>& lists, double enough) {
  return HWY_DYNAMIC_DISPATCH(test_octants)(box, lists, enough);
}

}  // namespace rectilin::certification
#endif

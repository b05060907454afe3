// foreach_target.h includes this file again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/sieve_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "certify/sieve_kernels.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rectilin::certification::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes8 = hn::CappedTag<double, 8>;  // eight octants go through registers of 2, 4 or 8 lanes
using V8 = hn::Vec<Lanes8>;

HWY_INLINE V8 all(double value) { return hn::Set(Lanes8(), value); }

constexpr std::size_t kMostOctants = 8 * kMostBoxes;

/// The middles of some octants of a box; they have half the edges of the box.
struct Middles {
  V8 c[3], e[3];

  HWY_INLINE Middles(const Box& box, std::size_t first) {
    for (int i = 0; i < 3; ++i) {
      e[i] = all(0.25 * (box.upper[i] - box.lower[i]));
      c[i] = hn::MulAdd(hn::LoadU(Lanes8(), kCornerSigns[i].data() + first), e[i],
                        all(0.5 * (box.lower[i] + box.upper[i])));
    }
  }
};

/// Where the octants' middles are in the whole box, in half edges from its middle.
using Places = std::array<std::array<float, kMostOctants>, 3>;

HWY_INLINE void find_places(const Box& box, const Box& whole, std::size_t to, Places& places) {
  const Eigen::Vector3d middle = box.centre() - whole.centre();
  const Eigen::Vector3d e = whole.half_edges().cwiseMax(std::numeric_limits<double>::min());
  for (int i = 0; i < 3; ++i) {
    const auto step = static_cast<float>(0.25 * (box.upper[i] - box.lower[i]) / e[i]);
    const auto at = static_cast<float>(middle[i] / e[i]);
    for (std::size_t octant = 0; octant < 8; ++octant)
      places[i][to + octant] = at + ((octant >> i) % 2 == 0 ? -step : step);
  }
}

/// For each octant a place in a list.
using Winners = std::array<std::uint32_t, kMostOctants>;

/// Chooses for each octant the row that is greatest at its middle.
HWY_INLINE void choose(const CutList& list, const Places& places, std::size_t octants, Winners& winners) {
  const hn::CappedTag<float, 16> d;
  const hn::RebindToUnsigned<decltype(d)> bits;
  using V = hn::Vec<decltype(d)>;
  using Bits = hn::Vec<decltype(bits)>;
  // A value's last seven bits hold the place in the list, which so wins with the value.
  static_assert(CutList::kMost == 128);
  const Bits place_bits = hn::Set(bits, 127), value_bits = hn::Not(place_bits), two = hn::Set(bits, 2);
  for (std::size_t first = 0; first < octants; first += hn::Lanes(d)) {
    const V x = hn::LoadU(d, places[0].data() + first), y = hn::LoadU(d, places[1].data() + first),
            z = hn::LoadU(d, places[2].data() + first);
    const auto value = [&](std::size_t j, Bits place) HWY_ATTR {
      const V with_x = hn::MulAdd(hn::Set(d, list.along[0][j]), x, hn::Set(d, list.lead[j]));
      const V with_y = hn::MulAdd(hn::Set(d, list.along[1][j]), y, with_x);
      const V sum = hn::MulAdd(hn::Set(d, list.along[2][j]), z, with_y);
      return hn::BitCast(d, hn::OrAnd(place, hn::BitCast(bits, sum), value_bits));
    };
    V best = hn::Zero(d), other = best;
    Bits place = hn::Zero(bits), next = hn::Set(bits, 1);
    for (std::size_t j = 0; j < list.size; j += 2) {  // the list has one row more
      best = hn::Max(best, value(j, place)), other = hn::Max(other, value(j + 1, next));
      place = hn::Add(place, two), next = hn::Add(next, two);
    }
    hn::StoreU(hn::And(hn::BitCast(bits, hn::Max(best, other)), place_bits), bits, winners.data() + first);
  }
}

/// Rows of cuts, one in each lane.
struct Vectors {
  V8 x, y, z;

  HWY_INLINE Vectors(const CutTable& table, const CutList& list, const std::uint32_t* winners) {
    load(Lanes8(), [&](std::size_t lane) { return table.data(list.row[winners[lane]]); });
  }

 private:
#if HWY_CAP_GE256 && !HWY_HAVE_SCALABLE
  template <class D, class F>
  HWY_INLINE void load(D d, const F& row) {  // rows become columns in registers: stores of rows would delay loads
    const V8 even = rows(d, row, 0), odd = rows(d, row, 1), even2 = rows(d, row, 2), odd2 = rows(d, row, 3);
    const V8 xz = hn::InterleaveLower(d, even, odd), xz2 = hn::InterleaveLower(d, even2, odd2);
    const V8 y1 = hn::InterleaveUpper(d, even, odd), y2 = hn::InterleaveUpper(d, even2, odd2);
    x = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(xz2), xz);
    y = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(y2), y1);
    z = hn::OddEvenBlocks(xz2, hn::SwapAdjacentBlocks(xz));
  }

  /// A row, and in a register with eight lanes the fourth after it as well.
  template <class D, class F>
  HWY_INLINE static V8 rows(D d, const F& row, std::size_t lane) {
    if constexpr (hn::MaxLanes(d) == 8) {
      const hn::Half<D> half;
      return hn::Combine(d, hn::LoadU(half, row(lane + 4)), hn::LoadU(half, row(lane)));
    } else {
      return hn::LoadU(d, row(lane));
    }
  }
#else
  template <class D, class F>
  HWY_INLINE void load(D d, const F& row) {
    double components[3][8];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      for (std::size_t c = 0; c < 3; ++c) components[c][lane] = row(lane)[c];
    x = hn::LoadU(d, components[0]), y = hn::LoadU(d, components[1]), z = hn::LoadU(d, components[2]);
  }
#endif
};

HWY_INLINE void test_box(const Box& box, const CutLists& lists, const CutTable& table,
                         const std::uint32_t* const (&winners)[3], double enough, Octants& octants) {
  const Lanes8 d;
  const V8 zero = hn::Zero(d), two = all(2);
  octants.open = 0;
  for (std::size_t first = 0; first < 8; first += hn::Lanes(d)) {
    const Middles middles(box, first);
    const V8(&c)[3] = middles.c, (&e)[3] = middles.e;
    V8 beyond = zero;
    for (int i = 0; i < 3; ++i) beyond = hn::Add(beyond, hn::Max(hn::Sub(hn::Abs(c[i]), e[i]), zero));
    const Vectors g0(table, lists[0], winners[0] + first), g1(table, lists[1], winners[1] + first),
        g2(table, lists[2], winners[2] + first);

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
    V8 norm = all(1);
    for (const V8& ci : c) norm = hn::MulAdd(ci, ci, norm);
    hn::StoreU(hn::Add(hn::Div(f, norm), all(enough)), d, octants.value.data() + first);
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
}

void test_all(std::span<const Box> boxes, const Box& whole, const CutLists& lists, const CutTable& table, double enough,
              Octants* results) {
  Places places;
  std::array<Winners, 3> winners;
  for (std::size_t b = 0; b < boxes.size(); ++b) find_places(boxes[b], whole, 8 * b, places);
  if (boxes.size() % 2 == 1)  // a register may hold the octants of two boxes
    for (auto& place : places) std::fill_n(place.data() + 8 * boxes.size(), 8, 0.f);
  for (int k = 0; k < 3; ++k) choose(lists[k], places, 8 * boxes.size(), winners[k]);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    test_box(boxes[b], lists, table, {winners[0].data() + 8 * b, winners[1].data() + 8 * b, winners[2].data() + 8 * b},
             enough, results[b]);
}

}  // namespace
}  // namespace rectilin::certification::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin::certification {

HWY_EXPORT(test_all);

void test_octants(std::span<const Box> boxes, const Box& whole, const CutLists& lists, const CutTable& table,
                  double enough, Octants* results) {
  HWY_DYNAMIC_DISPATCH(test_all)(boxes, whole, lists, table, enough, results);
}

}  // namespace rectilin::certification
#endif

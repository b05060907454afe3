// The vector loops of the sum by runs, compiled once for each instruction set. foreach_target.h includes this file
// again for each instruction set and has to come first.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sums/run_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
// clang-format on

#include "sums/run_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "sums/cap-inl.h"
#include "sums/cap.h"
#include "sums/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rectilin::HWY_NAMESPACE {
namespace {

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

/// The sum for one direction over some runs. Two registers for each component take turns, so that an addition does not
/// wait for the one before.
template <class Sum>
class Pass {
 public:
  HWY_INLINE Pass(const Runs& runs, const RunQuery& query)
      : runs_(runs),
        a_(hn::Set(D(), query.slope.a)),
        b_(hn::Set(D(), query.slope.b)),
        reach_(hn::Set(D(), query.reach)) {}

  /// Adds a block of groups: those that the circle misses, then of those that it meets the runs that it misses, then
  /// the vectors of those that it meets.
  HWY_INLINE void add(std::size_t block) {
    const std::size_t lanes = hn::Lanes(D()), begin = block * kGroupsPerBlock;
    std::uint64_t groups = 0;  // a bit for each
    for (std::size_t i = 0; i < kGroupsPerBlock; i += 2 * lanes) {
      groups |= test(runs_.groups, begin + i, even_) << i;
      groups |= test(runs_.groups, begin + i + lanes, odd_) << (i + lanes);
    }
    std::uint64_t met[kGroupsPerBlock * kGroup / 64] = {};  // a bit for each run
    for (; groups != 0; groups &= groups - 1) {
      const auto group = static_cast<std::size_t>(std::countr_zero(groups)) * kGroup;
      for (std::size_t i = 0; i < kGroup; i += lanes)
        met[group / 64] |= test(runs_.runs, begin * kGroup + group + i, odd_) << (group + i) % 64;
    }
    for (std::size_t word = 0; word < std::size(met); ++word)
      for (std::uint64_t bits = met[word]; bits != 0; bits &= bits - 1)
        open(runs_.vectors, begin * kGroup + 64 * word + static_cast<std::size_t>(std::countr_zero(bits)));
  }

  /// Adds the vectors of a run one by one.
  HWY_INLINE void open(const VectorSpan<double>& vectors, std::size_t run) {
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = kRunLength * run; i < kRunLength * (run + 1); i += 2 * lanes) {
      look(vectors, i, even_);
      look(vectors, i + lanes, odd_);
    }
  }

  HWY_INLINE void add_to_lanes(double* lanes) const {
    even_.add_to_lanes(lanes);
    odd_.add_to_lanes(lanes);
  }

 private:
  HWY_INLINE V product(V x, V y, V z) const { return hn::MulAdd(a_, x, hn::MulAdd(b_, y, z)); }

  HWY_INLINE std::uint64_t test(const Caps& caps, std::size_t i, Sum& sum) const {
    const D d;
    const V x = hn::Load(d, caps.sums.x + i), y = hn::Load(d, caps.sums.y + i), z = hn::Load(d, caps.sums.z + i);
    const V s = product(x, y, z);
    const auto meets = hn::Lt(hn::Abs(s), hn::Mul(hn::Load(d, caps.radius + i), reach_));
    sum.add(x, y, z, hn::IfThenZeroElse(meets, s));
    std::uint8_t byte[8] = {};
    hn::StoreMaskBits(d, meets, byte);
    return byte[0];
  }

  HWY_INLINE void look(const VectorSpan<double>& vectors, std::size_t i, Sum& sum) const {
    const D d;
    const V x = hn::LoadU(d, vectors.x + i), y = hn::LoadU(d, vectors.y + i), z = hn::LoadU(d, vectors.z + i);
    sum.add(x, y, z, product(x, y, z));
  }

  const Runs runs_;
  const V a_, b_, reach_;
  Sum even_, odd_;
};

template <class Sum>
HWY_INLINE void sum_all(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  constexpr std::size_t kLanes = Sum::kOutputs * hn::MaxLanes(D());
  HWY_ALIGN double lanes[kSlab * kLanes];
  std::fill_n(lanes, directions * kLanes, 0.0);
  for (std::size_t block = 0; block < runs.groups.sums.size / kGroupsPerBlock; ++block)
    for (std::size_t k = 0; k < directions; ++k) {
      Pass<Sum> pass(runs, queries[k]);
      pass.add(block);
      pass.add_to_lanes(lanes + k * kLanes);
    }
  for (std::size_t k = 0; k < directions; ++k) {
    Pass<Sum> pass(runs, queries[k]);
    pass.open(runs.rest, 0);
    pass.add_to_lanes(lanes + k * kLanes);
  }
  const D d;
  for (std::size_t i = 0; i < directions * Sum::kOutputs; ++i)
    sums[i] += lane_sum(d, hn::Load(d, lanes + i * hn::Lanes(d)));
}

void sum_parts(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  sum_all<NegativePart<D>>(runs, queries, directions, sums);
}

void sum_vectors(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  sum_all<NegativeSum<D>>(runs, queries, directions, sums);
}

void all_caps(const VectorSpan<double>& vectors, std::size_t length, double* x, double* y, double* z, double* radius) {
  const D d;
  for (std::size_t begin = 0, run = 0; begin < vectors.size; begin += length, ++run) {
    const std::size_t end = std::min(begin + length, vectors.size);
    const auto total = [&](const double* c) HWY_ATTR {
      V sum = hn::LoadU(d, c + begin);
      for (std::size_t i = begin + hn::Lanes(d); i < end; i += hn::Lanes(d)) sum = hn::Add(sum, hn::LoadU(d, c + i));
      return lane_sum(d, sum);
    };
    x[run] = total(vectors.x), y[run] = total(vectors.y), z[run] = total(vectors.z);
    const double norm = std::sqrt(x[run] * x[run] + y[run] * y[run] + z[run] * z[run]);
    const V ax = hn::Set(d, x[run] / norm), ay = hn::Set(d, y[run] / norm), az = hn::Set(d, z[run] / norm);
    V largest = hn::Zero(d);
    for (std::size_t i = begin; i < end; i += hn::Lanes(d))
      largest = hn::Max(largest, squared_sine(d, hn::LoadU(d, vectors.x + i), hn::LoadU(d, vectors.y + i),
                                              hn::LoadU(d, vectors.z + i), ax, ay, az));
    radius[run] = cap_radius(norm, hn::GetLane(hn::MaxOfLanes(d, largest)));
  }
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(sum_parts);
HWY_EXPORT(sum_vectors);
HWY_EXPORT(all_caps);

void sum_negative_parts(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  HWY_DYNAMIC_DISPATCH(sum_parts)(runs, queries, directions, sums);
}

void sum_negative_vectors(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  HWY_DYNAMIC_DISPATCH(sum_vectors)(runs, queries, directions, sums);
}

void find_caps(const VectorSpan<double>& vectors, std::size_t length, double* x, double* y, double* z, double* radius) {
  HWY_DYNAMIC_DISPATCH(all_caps)(vectors, length, x, y, z, radius);
}

}  // namespace rectilin
#endif

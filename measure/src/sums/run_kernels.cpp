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

  /// Adds at most 64 runs: those that the circle misses, then the vectors of those that it meets.
  HWY_INLINE void add(std::size_t begin, std::size_t end) {
    const std::size_t lanes = hn::Lanes(D());
    std::uint64_t met = 0;  // a bit for each run
    for (std::size_t i = begin; i < end; i += 2 * lanes) {
      met |= test(i, even_) << (i - begin);
      met |= test(i + lanes, odd_) << (i + lanes - begin);
    }
    while (met != 0) {
      open(runs_.vectors, begin + static_cast<std::size_t>(std::countr_zero(met)));
      met &= met - 1;
    }
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

  HWY_INLINE std::uint64_t test(std::size_t i, Sum& sum) const {
    const D d;
    const V x = hn::Load(d, runs_.sums.x + i), y = hn::Load(d, runs_.sums.y + i), z = hn::Load(d, runs_.sums.z + i);
    const V s = product(x, y, z);
    const auto meets = hn::Lt(hn::Abs(s), hn::Mul(hn::Load(d, runs_.radius + i), reach_));
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
  for (std::size_t begin = 0; begin < runs.sums.size; begin += kRunsPerBlock) {
    const std::size_t end = std::min(begin + kRunsPerBlock, runs.sums.size);
    for (std::size_t k = 0; k < directions; ++k) {
      Pass<Sum> pass(runs, queries[k]);
      for (std::size_t i = begin; i < end; i += 64) pass.add(i, std::min(i + 64, end));
      pass.add_to_lanes(lanes + k * kLanes);
    }
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

void fill(const VectorSpan<double>& vectors, double* x, double* y, double* z, double* radius) {
  const D d;
  for (std::size_t run = 0; run < vectors.size / kRunLength; ++run) {
    const std::size_t begin = kRunLength * run, end = begin + kRunLength;
    const auto total = [&](const double* c) HWY_ATTR {
      V sum = hn::LoadU(d, c + begin);
      for (std::size_t i = begin + hn::Lanes(d); i < end; i += hn::Lanes(d)) sum = hn::Add(sum, hn::LoadU(d, c + i));
      return lane_sum(d, sum);
    };
    x[run] = total(vectors.x), y[run] = total(vectors.y), z[run] = total(vectors.z);
    const double length = std::sqrt(x[run] * x[run] + y[run] * y[run] + z[run] * z[run]);
    const V ax = hn::Set(d, x[run] / length), ay = hn::Set(d, y[run] / length), az = hn::Set(d, z[run] / length);
    V largest = hn::Zero(d);
    for (std::size_t i = begin; i < end; i += hn::Lanes(d))
      largest = hn::Max(largest, squared_sine(d, hn::LoadU(d, vectors.x + i), hn::LoadU(d, vectors.y + i),
                                              hn::LoadU(d, vectors.z + i), ax, ay, az));
    radius[run] = cap_radius(length, hn::GetLane(hn::MaxOfLanes(d, largest)));
  }
}

}  // namespace
}  // namespace rectilin::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rectilin {

HWY_EXPORT(sum_parts);
HWY_EXPORT(sum_vectors);
HWY_EXPORT(fill);

void sum_negative_parts(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  HWY_DYNAMIC_DISPATCH(sum_parts)(runs, queries, directions, sums);
}

void sum_negative_vectors(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  HWY_DYNAMIC_DISPATCH(sum_vectors)(runs, queries, directions, sums);
}

void fill_runs(const VectorSpan<double>& vectors, double* x, double* y, double* z, double* radius) {
  HWY_DYNAMIC_DISPATCH(fill)(vectors, x, y, z, radius);
}

}  // namespace rectilin
#endif

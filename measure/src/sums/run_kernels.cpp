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

using D = hn::CappedTag<double, kRunLength>;
using V = hn::Vec<D>;
using Sum = NegativeSum<D>;

/// Sums the runs `begin` to `end` that the circle misses, then the vectors of those that it meets. Two sums take turns,
/// so that an addition does not wait for the one before.
HWY_INLINE void add_runs(const Runs& runs, std::size_t begin, std::size_t end, const RunQuery& query, double* lanes) {
  const D d;
  const V a = hn::Set(d, query.slope.a), b = hn::Set(d, query.slope.b), reach = hn::Set(d, query.reach);
  std::uint64_t met[kRunsPerBlock / 64] = {};  // a bit for each run
  Sum even, odd;
  const auto test = [&](std::size_t i, Sum& sum) HWY_ATTR {
    const V x = hn::Load(d, runs.sums.x + i), y = hn::Load(d, runs.sums.y + i), z = hn::Load(d, runs.sums.z + i);
    const V s = hn::MulAdd(a, x, hn::MulAdd(b, y, z));
    const auto meets = hn::Lt(hn::Abs(s), hn::Mul(hn::Load(d, runs.radius + i), reach));
    sum.add(x, y, z, hn::IfThenZeroElse(meets, s));
    std::uint8_t byte[8] = {};
    hn::StoreMaskBits(d, meets, byte);
    met[(i - begin) / 64] |= std::uint64_t{byte[0]} << (i - begin) % 64;
  };
  for (std::size_t i = begin; i < end; i += 2 * hn::Lanes(d)) {
    test(i, even);
    test(i + hn::Lanes(d), odd);
  }
  const auto open = [&](std::size_t run, Sum& sum) HWY_ATTR {
    for (std::size_t i = kRunLength * run; i < kRunLength * (run + 1); i += hn::Lanes(d)) {
      const V x = hn::LoadU(d, runs.vectors.x + i), y = hn::LoadU(d, runs.vectors.y + i),
              z = hn::LoadU(d, runs.vectors.z + i);
      sum.add(x, y, z, hn::MulAdd(a, x, hn::MulAdd(b, y, z)));
    }
  };
  const auto first_of = [](std::uint64_t bits) { return static_cast<std::size_t>(std::countr_zero(bits)); };
  for (std::size_t word = 0; word < std::size(met); ++word)
    for (std::uint64_t bits = met[word]; bits != 0; bits &= bits - 1) {
      const std::size_t first = begin + 64 * word;
      open(first + first_of(bits), even);
      bits &= bits - 1;
      if (bits == 0) break;
      open(first + first_of(bits), odd);
    }
  even.add_to_lanes(lanes);
  odd.add_to_lanes(lanes);
}

void sum_all(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  constexpr std::size_t kLanes = Sum::kOutputs * hn::MaxLanes(D());
  HWY_ALIGN double lanes[kSlab * kLanes];
  std::fill_n(lanes, directions * kLanes, 0.0);
  for (std::size_t begin = 0; begin < runs.sums.size; begin += kRunsPerBlock) {
    const std::size_t end = std::min(begin + kRunsPerBlock, runs.sums.size);
    for (std::size_t k = 0; k < directions; ++k) add_runs(runs, begin, end, queries[k], lanes + k * kLanes);
  }
  const D d;
  for (std::size_t i = 0; i < directions * Sum::kOutputs; ++i)
    sums[i] += lane_sum(d, hn::Load(d, lanes + i * hn::Lanes(d)));
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

HWY_EXPORT(sum_all);
HWY_EXPORT(fill);

void sum_negative(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums) {
  HWY_DYNAMIC_DISPATCH(sum_all)(runs, queries, directions, sums);
}

void fill_runs(const VectorSpan<double>& vectors, double* x, double* y, double* z, double* radius) {
  HWY_DYNAMIC_DISPATCH(fill)(vectors, x, y, z, radius);
}

}  // namespace rectilin
#endif

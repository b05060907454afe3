#include "rectilin/measure/run_sum.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "rectilin/base/ceil_div.h"
#include "sums/run_kernels.h"
#include "sums/two_sum.h"

namespace rectilin {
namespace {

constexpr std::size_t kDirectionsPerTask = 24;

// Below this many pairs of a run and a direction, some 50 microseconds of work, tasks cost more than they save.
constexpr std::size_t kSerialRuns = std::size_t{1} << 17;

/// The sums and the radii of the caps of `length` vectors each, then zeros: `padded` of each.
AlignedDoubles caps_of(const VectorSpan<double>& vectors, std::size_t length, std::size_t padded) {
  AlignedDoubles caps(4 * padded);
  double* x = caps.data();
  find_caps(vectors, length, x, x + padded, x + 2 * padded, x + 3 * padded);
  return caps;
}

VectorSpan<double> columns(const AlignedDoubles& values, std::size_t size) {
  const double* x = values.data();
  return {x, x + size, x + 2 * size, size};
}

Caps view(const AlignedDoubles& caps) {
  const std::size_t size = caps.size() / 4;
  return {columns(caps, size), caps.data() + 3 * size};
}

}  // namespace

RunSum::RunSum(const AreaVectors& vectors) : vectors_(&vectors), rest_(3 * kRunLength) {
  const std::size_t count = vectors.size() / kRunLength, whole = count * kRunLength, groups = ceil_div(count, kGroup);
  const VectorSpan<double> all = {vectors.x.data(), vectors.y.data(), vectors.z.data(), whole};
  runs_ = caps_of(all, kRunLength, groups * kGroup);
  groups_ = caps_of(all, kRunLength * kGroup, ceil_div(groups, kGroupsPerBlock) * kGroupsPerBlock);
  const AlignedDoubles* components[] = {&vectors.x, &vectors.y, &vectors.z};
  for (std::size_t c = 0; c < 3; ++c) {
    double* rest = &rest_[c * kRunLength];
    std::copy(components[c]->begin() + static_cast<std::ptrdiff_t>(whole), components[c]->end(), rest);
    TwoSum total{};
    for (std::size_t run = 0; run < count; ++run) total.add(runs_[c * groups * kGroup + run]);
    for (std::size_t i = 0; i < kRunLength; ++i) total.add(rest[i]);
    total_[static_cast<int>(c)] = total.value();
  }
}

/// Calls `finish(u, scale, sums)` to turn a kernel's sums for each direction into a result.
template <class Result, class Finish>
void RunSum::evaluate(RunKernel kernel, std::size_t width, std::span<const Vector3> u, std::span<Result> results,
                      const Finish& finish) const {
  assert(u.size() == results.size());
  const Runs runs = {{vectors_->x.data(), vectors_->y.data(), vectors_->z.data(), vectors_->size()},
                     view(runs_),
                     view(groups_),
                     columns(rest_, kRunLength)};
  const auto some = [&](std::size_t task) {
    const std::size_t begin = task * kDirectionsPerTask, count = std::min(kDirectionsPerTask, u.size() - begin);
    std::array<double, kDirectionsPerTask> scale;
    std::array<RunQuery, kDirectionsPerTask> queries{};
    std::array<double, 3 * kDirectionsPerTask> sums{};
    for (std::size_t k = 0; k < count; ++k) {
      scale[k] = slope_scale<double>(u[begin + k]);
      const Slope<double> s = slope<double>(u[begin + k], scale[k]);
      queries[k] = {s, std::sqrt(1 + s.a * s.a + s.b * s.b)};
    }
    kernel(runs, queries.data(), count, sums.data());
    for (std::size_t k = 0; k < count; ++k) results[begin + k] = finish(u[begin + k], scale[k], &sums[width * k]);
  };
  const std::size_t tasks = ceil_div(u.size(), kDirectionsPerTask);
  if (runs.runs.sums.size * u.size() >= kSerialRuns) tbb::parallel_for(std::size_t{0}, tasks, some);
  else
    for (std::size_t task = 0; task < tasks; ++task) some(task);
}

void RunSum::values(std::span<const Vector3> u, std::span<double> h) const {
  evaluate(sum_negative_parts, 1, u, h, [this](const Vector3& w, double scale, const double* part) {
    return value_from_negative(total_, w, scale, *part);
  });
}

void RunSum::cuts(std::span<const Vector3> u, std::span<Vector3> g) const {
  evaluate(sum_negative_vectors, 3, u, g, [this](const Vector3&, double scale, const double* sum) {
    return cut_from_negative(total_, scale, {sum[0], sum[1], sum[2]});
  });
}

bool RunSum::worthwhile(std::size_t vectors) {
  return vectors >= 500 && vectors < 100'000;  // measured (papers/throughput.md)
}

}  // namespace rectilin

// Splits flat sums into kernel calls over chunks of vectors and slabs of directions, and shares them among threads.
#include "rectilin/measure/flat_sum.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "rectilin/base/ceil_div.h"
#include "sums/flat_sum_kernels.h"
#include "sums/two_sum.h"

namespace rectilin {

/// The area vectors in the form that the kernels read: whole cache lines in place, the rest padded with zeros.
template <class T>
struct FlatFaces {
  VectorSpan<T> whole, tail;

  std::size_t chunks() const { return std::max<std::size_t>(1, ceil_div(whole.size, kChunk)); }

  void sum_chunk(FlatKernel<T> kernel, std::size_t chunk, std::span<const Slope<T>> slopes, double* sums) const {
    const std::size_t begin = chunk * kChunk, end = std::min(begin + kChunk, whole.size);
    const bool last = end == whole.size;
    kernel(whole.slice(begin, end), tail.slice(0, last ? tail.size : 0), slopes.data(), slopes.size(), sums);
  }
};

namespace {

// Number of directions in a task, a multiple of the group size of every kernel. 32 would divide a population of fifty
// rotations unevenly between two threads.
constexpr std::size_t kTaskDirections = 24;

// Below this many pairs of a vector and a direction, some 50 microseconds of work, tasks cost more than they save.
constexpr std::size_t kSerialPairs = std::size_t{1} << 21;

enum class Schedule { kSerial, kThreads };

/// The kernel sums for one slab of directions. Chunks are combined in the order of their index, whether threads summed
/// them or not, so the bits are the same either way.
template <class T>
void sum_faces(const FlatFaces<T>& faces, FlatKernel<T> kernel, std::span<const Slope<T>> slopes,
               std::span<TwoSum> sums, Schedule schedule) {
  const std::size_t chunks = faces.chunks();
  if (schedule == Schedule::kSerial) {
    std::array<double, 3 * kSlab> part;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      std::fill_n(part.begin(), sums.size(), 0.0);
      faces.sum_chunk(kernel, chunk, slopes, part.data());
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(part[i]);
    }
  } else {
    const std::size_t groups = ceil_div(slopes.size(), kTaskDirections), width = sums.size() / slopes.size();
    std::vector<double> parts(chunks * sums.size());
    tbb::parallel_for(std::size_t{0}, chunks * groups, [&](std::size_t task) {
      const std::size_t chunk = task / groups, first = task % groups * kTaskDirections;
      const std::size_t count = std::min(kTaskDirections, slopes.size() - first);
      faces.sum_chunk(kernel, chunk, slopes.subspan(first, count), &parts[chunk * sums.size() + first * width]);
    });
    for (std::size_t i = 0; i < parts.size(); ++i) sums[i % sums.size()].add(parts[i]);
  }
}

/// Results for one slab of directions: makes the slopes, sums, and calls `finish(u, scale, sums)` to turn kernel sums
/// into a result.
template <class T, class Result, class Finish>
void evaluate_slab(const FlatFaces<T>& faces, const FlatKernels& kernels, FlatQuantity quantity,
                   std::span<const Vector3> u, std::span<Result> results, const Finish& finish, Schedule schedule) {
  const std::size_t width = outputs(quantity);
  std::array<double, kSlab> scale;
  std::array<Slope<T>, kSlab> slopes;
  std::array<TwoSum, 3 * kSlab> sums;
  for (std::size_t k = 0; k < u.size(); ++k) {
    scale[k] = slope_scale<T>(u[k]);
    slopes[k] = slope<T>(u[k], scale[k]);
  }
  std::fill_n(sums.begin(), width * u.size(), TwoSum{});
  sum_faces<T>(faces, kernels.get<T>(quantity), {slopes.data(), u.size()}, {sums.data(), width * u.size()}, schedule);
  for (std::size_t k = 0; k < u.size(); ++k) results[k] = finish(u[k], scale[k], &sums[width * k]);
}

/// Does all directions: serially if there is little to do, otherwise with threads that share the directions and, if
/// there is more than one chunk, the vectors.
template <class T, class Result, class Finish>
void evaluate_all(const FlatFaces<T>& faces, const FlatKernels& kernels, FlatQuantity quantity,
                  std::span<const Vector3> u, std::span<Result> results, const Finish& finish) {
  assert(u.size() == results.size());
  const auto slab = [&](std::size_t begin, std::size_t size, Schedule schedule) {
    const std::size_t count = std::min(size, u.size() - begin);
    evaluate_slab<T, Result>(faces, kernels, quantity, u.subspan(begin, count), results.subspan(begin, count), finish,
                             schedule);
  };
  const std::size_t tasks = ceil_div(u.size(), kTaskDirections);
  const bool serial = faces.whole.size * u.size() < kSerialPairs;
  if (!serial && faces.chunks() == 1) {
    tbb::parallel_for(std::size_t{0}, tasks,
                      [&](std::size_t task) { slab(task * kTaskDirections, kTaskDirections, Schedule::kSerial); });
    return;
  }
  const Schedule schedule = serial ? Schedule::kSerial : Schedule::kThreads;
  for (std::size_t k = 0; k < u.size(); k += kSlab) slab(k, kSlab, schedule);
}

Vector3 vector(const TwoSum* sums) { return {sums[0].value(), sums[1].value(), sums[2].value()}; }

std::size_t whole_lanes(std::size_t size, std::size_t lane) { return size / lane * lane; }

}  // namespace

FlatSum::FlatSum(const AreaVectors& vectors, Precision precision)
    : vectors_(&vectors), precision_(precision), kernels_(&flat_kernels()) {
  const std::array<const AlignedDoubles*, 3> components = {&vectors.x, &vectors.y, &vectors.z};
  if (precision == Precision::kSingle) {
    const std::size_t padded = whole_lanes(size() + kLane<float> - 1, kLane<float>);
    single_.resize(3 * padded);
    for (std::size_t c = 0; c < 3; ++c) {
      std::transform(components[c]->begin(), components[c]->end(), single_.begin() + c * padded,
                     [](double v) { return static_cast<float>(v); });
    }
  } else {
    const std::size_t whole = whole_lanes(size(), kLane<double>);
    for (std::size_t c = 0; c < 3; ++c) {
      std::copy(components[c]->begin() + whole, components[c]->end(), &tail_[c * kLane<double>]);
    }
  }
  const Vector3 any = Vector3::UnitZ();
  evaluate(kTotal, std::span(&any, 1), std::span(&total_, 1),
           [](const Vector3&, double, const TwoSum* sums) { return vector(sums); });
}

FlatFaces<float> FlatSum::single_faces() const {
  const std::size_t padded = single_.size() / 3;
  const float* x = single_.data();
  return {{x, x + padded, x + 2 * padded, padded}, {x, x, x, 0}};
}

FlatFaces<double> FlatSum::double_faces() const {
  const std::size_t whole = whole_lanes(size(), kLane<double>);
  const double* tail = tail_.data();
  return {{vectors_->x.data(), vectors_->y.data(), vectors_->z.data(), whole},
          {tail, tail + kLane<double>, tail + 2 * kLane<double>, whole < size() ? kLane<double> : 0}};
}

template <class Result, class Finish>
void FlatSum::evaluate(FlatQuantity quantity, std::span<const Vector3> u, std::span<Result> results,
                       const Finish& finish) const {
  if (precision_ == Precision::kSingle) {
    evaluate_all(single_faces(), *kernels_, quantity, u, results, finish);
  } else {
    evaluate_all(double_faces(), *kernels_, quantity, u, results, finish);
  }
}

void FlatSum::values(std::span<const Vector3> u, std::span<double> h) const {
  evaluate(kNegativePart, u, h, [this](const Vector3& w, double scale, const TwoSum* part) {
    return value_from_negative(total_, w, scale, part->value());
  });
}

void FlatSum::cuts(std::span<const Vector3> u, std::span<Vector3> g) const {
  evaluate(kNegativeSum, u, g, [this](const Vector3&, double scale, const TwoSum* sum) {
    return cut_from_negative(total_, scale, vector(sum));
  });
}

double FlatSum::relative_error_bound(Precision precision) {
  // In units of roundoff, for the least number of lanes, one: the kBlock terms of a block, the kChunk / kBlock blocks
  // of a chunk, and 8 for a projection (slopes, multiply-adds, fused or not, conversion of the components). Up to
  // sixteen lanes, and the sums of chunks, are added in double precision, or before that in four steps. Chunks are
  // combined with compensation. Both the negative part, which counts twice, and the total have this error.
  const auto error = [](std::size_t block, double roundoff) {
    return 3 * (static_cast<double>(block + kChunk / block + 8 + 4) * roundoff + 2 * 0x1p-53);
  };
  return precision == Precision::kSingle ? error(kBlock<float>, 0x1p-24) : error(kBlock<double>, 0x1p-53);
}

std::size_t FlatSum::bytes() const { return sizeof(*this) + single_.capacity() * sizeof(float); }

}  // namespace rectilin

// The exact minimum over all turns about one axis of the frame: the planar problem of Zunic and Rosin (2003).
//
// Seen along the axis, an area vector has a length rho and an angle -psi. When the frame turns by t, it adds rho
// (|cos(t - psi)| + |sin(t - psi)|), which has period pi/2 in t, a kink at psi, and is concave elsewhere. So the sum
// has its minimum at a kink, and sorting all kinks finds it. Most kinks need no sorting: the quarter circle is divided
// into buckets. Merging the vectors of a bucket into one does not change the sum at the bucket's ends, and only lowers
// it in between, where it is least at the kink of the merged vector. A bucket whose least value is above the sum at the
// end of some bucket cannot hold the minimum.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "objective/turn_kernels.h"
#include "rectilin/measure/projected_area.h"

namespace rectilin {
namespace {

struct Planar {
  double x = 0, y = 0;
  Planar operator+(const Planar& o) const { return {x + o.x, y + o.y}; }
  Planar operator-(const Planar& o) const { return {x - o.x, y - o.y}; }
};

/// The sum at the angle of `at`, where `behind` = (X, Y) is the sum of the vectors with smaller angles and (U, V), the
/// rest of `total`, is the sum of the others:
///     X (c + s) + Y (s - c) + U (c - s) + V (s + c).
/// NaN for a vector that contributes nothing to the sum: of length zero, or so short that its square vanishes.
double sum_at(const Planar& at, const Planar& behind, const Planar& total) {
  return (at.x * (total.x + total.y - 2 * behind.y) + at.y * (total.y - total.x + 2 * behind.x)) /
         std::sqrt(at.x * at.x + at.y * at.y);
}

struct Least {
  Planar at;
  double value;
  void offer(const Planar& where, double found) {
    if (found < value) *this = {where, found};
  }
};

/// A bucket costs about as much as viewing kPerBucket vectors; a few buckets are worth it for any number.
constexpr std::size_t kPerBucket = 16, kFewBuckets = 16, kMostBuckets = 4096;
/// Number of vectors viewed at a time, on the stack.
constexpr std::size_t kTurnBlock = 512;
/// Least number of vectors for a task, and largest number of tasks: each has its own sums for all buckets.
constexpr std::size_t kTask = 32768, kMostTasks = 16;

/// All vectors as seen along one axis, sorted into buckets of nearly equal angles.
class Buckets {
 public:
  Buckets(const AreaVectors& vectors, const Vector3& first, const Vector3& second)
      : faces_{vectors.x.data(), vectors.y.data(), vectors.z.data(), vectors.size()},
        count_(std::min(kFewBuckets + vectors.size() / kPerBucket, kMostBuckets)),
        view_{first, second, static_cast<double>(count_)},
        bucket_of_(vectors.size()),
        before_(count_ + 1) {
    const std::size_t task = std::max(kTask, faces_.size / kMostTasks + 1);
    const std::size_t tasks = (faces_.size + task - 1) / task;
    std::vector<std::vector<Planar>> parts(tasks);
    const auto sum_part = [&](std::size_t i) { parts[i] = sums(i * task, std::min((i + 1) * task, faces_.size)); };
    if (tasks > 1) tbb::parallel_for(std::size_t{0}, tasks, sum_part);
    else sum_part(0);
    for (std::size_t b = 0; b < count_; ++b) {
      before_[b + 1] = before_[b];
      for (const auto& part : parts) before_[b + 1] = before_[b + 1] + part[b];
    }
  }

  /// The minimum over all angles.
  Least least() const {
    Least least{{1, 0}, sum_at({1, 0}, {}, before_.back())};
    for (std::size_t b = 1; b < count_; ++b) {
      const double place = static_cast<double>(b) / view_.buckets;
      const Planar end{1 - place, place};
      least.offer(end, sum_at(end, before_[b], before_.back()));
    }
    std::vector<char> open(count_);
    for (std::size_t b = 0; b < count_; ++b) {
      const Planar merged = before_[b + 1] - before_[b];
      open[b] = sum_at(merged, before_[b], before_.back()) < least.value;
    }
    sweep(kinks_of(open), least);
    return least;
  }

 private:
  struct Kink {
    std::int32_t bucket;
    double place;
    Planar v;
  };

  /// The sums of the buckets over the vectors [begin, end); notes the bucket of each.
  std::vector<Planar> sums(std::size_t begin, std::size_t end) {
    // Neighbours are often in the same bucket: two sums used in turns do not wait for each other.
    std::vector<std::array<Planar, 2>> pairs(count_);
    std::array<double, kTurnBlock> x, y;
    for (; begin < end; begin += kTurnBlock) {
      const std::size_t size = std::min(kTurnBlock, end - begin);
      view_vectors(faces_.slice(begin, begin + size), view_, x.data(), y.data(), &bucket_of_[begin]);
      for (std::size_t i = 0; i < size; ++i) {
        Planar& sum = pairs[bucket_of_[begin + i]][i % 2];
        sum.x += x[i];
        sum.y += y[i];
      }
    }
    std::vector<Planar> result(count_);
    for (std::size_t b = 0; b < count_; ++b) result[b] = pairs[b][0] + pairs[b][1];
    return result;
  }

  /// The kinks of the open buckets, sorted.
  std::vector<Kink> kinks_of(const std::vector<char>& open) const {
    std::vector<Kink> kinks;
    std::array<double, kTurnBlock> x, y;
    std::array<std::int32_t, kTurnBlock> bucket;
    for (std::size_t begin = 0; begin < faces_.size; begin += kTurnBlock) {
      const std::size_t size = std::min(kTurnBlock, faces_.size - begin);
      const auto is_open = [&](std::int32_t b) { return open[b] != 0; };
      if (std::none_of(&bucket_of_[begin], &bucket_of_[begin] + size, is_open)) continue;
      view_vectors(faces_.slice(begin, begin + size), view_, x.data(), y.data(), bucket.data());
      for (std::size_t i = 0; i < size; ++i)
        if (open[bucket[i]]) kinks.push_back({bucket[i], QuadrantView::place(x[i], y[i]), {x[i], y[i]}});
    }
    std::ranges::sort(kinks, [](const Kink& a, const Kink& b) {
      return a.bucket != b.bucket ? a.bucket < b.bucket : a.place < b.place;
    });
    return kinks;
  }

  /// Compares the sum at each kink with the least one so far.
  void sweep(const std::vector<Kink>& kinks, Least& least) const {
    Planar behind;
    for (std::size_t i = 0; i < kinks.size(); ++i) {
      if (i == 0 || kinks[i].bucket != kinks[i - 1].bucket) behind = before_[kinks[i].bucket];
      behind = behind + kinks[i].v;
      least.offer(kinks[i].v, sum_at(kinks[i].v, behind, before_.back()));
    }
  }

  VectorSpan<double> faces_;
  std::size_t count_;
  QuadrantView view_;
  std::vector<std::int32_t> bucket_of_;
  std::vector<Planar> before_;  // sum of all vectors in the buckets before this one
};

}  // namespace

BestTurn ProjectedArea::best_turn(const Rotation& rotation, int k) const {
  const Planar at = Buckets(vectors_, rotation.axis((k + 1) % 3), rotation.axis((k + 2) % 3)).least().at;
  // The running sums lose digits, so the value returned is the one that values() gives at the end. Going through a
  // quaternion keeps long chains of turns orthonormal.
  const Vector3 turn = std::atan2(at.y, at.x) * Vector3::Unit(k);
  BestTurn best;
  best.rotation = Rotation::from_quaternion((rotation_from_vector(turn) * rotation).quaternion());
  best.value = value(best.rotation);
  return best;
}

}  // namespace rectilin

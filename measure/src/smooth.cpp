// The objective with its kinks rounded off: |x| becomes sqrt(x^2 + e^2).
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>

#include "rectilin/measure/projected_area.h"

namespace rectilin {

SmoothValue ProjectedArea::smooth(const Rotation& rotation, double width) const {
  const Eigen::Matrix3d& r = rotation.matrix();
  const auto sum_block = [&](const tbb::blocked_range<std::size_t>& block, SmoothValue sum) {
    for (std::size_t i = block.begin(); i < block.end(); ++i) {
      const Vector3 v = vectors_[i];
      const Vector3 along = r * v;
      const double softening = width * width * v.squaredNorm();  // e = width |v|: an angle for every face
      const Vector3 rounded = (along.array().square() + softening).sqrt();
      sum.value += rounded.sum();
      sum.gradient += (along.array() / rounded.array()).matrix() * v.transpose();
    }
    return sum;
  };
  // Fixed blocks, joined in a fixed order: the same bits for any number of threads.
  SmoothValue sum = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, vectors_.size(), 4096), SmoothValue{0, Eigen::Matrix3d::Zero()}, sum_block,
      [](const SmoothValue& a, const SmoothValue& b) { return SmoothValue{a.value + b.value, a.gradient + b.gradient}; },
      tbb::simple_partitioner());
  sum.value /= vectors_.total;
  sum.gradient /= vectors_.total;
  return sum;
}

}  // namespace rectilin

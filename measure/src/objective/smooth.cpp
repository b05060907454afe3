// The objective with its kinks rounded off: |x| becomes sqrt(x^2 + e^2).
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "objective/smooth_kernels.h"
#include "rectilin/measure/projected_area.h"

namespace rectilin {
namespace {

// Number of vectors that are summed in registers before they are added up: some ten microseconds of work, enough for
// a task.
constexpr std::size_t kSmoothBlock = 8192;

}  // namespace

SmoothValue ProjectedArea::smooth(const Rotation& rotation, double width) const {
  const VectorSpan<double> faces{vectors_.x.data(), vectors_.y.data(), vectors_.z.data(), vectors_.size()};
  const auto add_block = [&](const tbb::blocked_range<std::size_t>& block, SmoothSums sums) {
    const SmoothSums own = smooth_sums(faces.slice(block.begin(), block.end()), rotation.matrix(), width);
    return SmoothSums{sums.value + own.value, sums.gradient + own.gradient};
  };
  // The blocks are fixed and joined in a fixed order, so the bits are the same for any number of threads.
  const tbb::blocked_range<std::size_t> all(0, faces.size, kSmoothBlock);
  const SmoothSums sums = all.is_divisible() ? tbb::parallel_deterministic_reduce(
                                                   all, SmoothSums{}, add_block,
                                                   [](const SmoothSums& a, const SmoothSums& b) {
                                                     return SmoothSums{a.value + b.value, a.gradient + b.gradient};
                                                   },
                                                   tbb::simple_partitioner())
                                             : add_block(all, {});
  return {sums.value / vectors_.total, sums.gradient / vectors_.total};
}

}  // namespace rectilin

// Answers queries of a normal tree, spread over threads.
#include "rectilin/measure/normal_tree.h"

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>

#include "normal_kernels.h"

namespace rectilin {
namespace {

// Nodes that a task visits at least, estimated as the square root of the number of vectors for each
// direction: some 20 microseconds.
constexpr double kTaskVisits = 8192;

}  // namespace

template <class Result, class Finish>
void NormalTree::evaluate(std::span<const Vector3> u, std::span<Result> results, double resolution,
                          const Finish& finish) const {
  assert(u.size() == results.size());
  const double sine = std::sin(resolution);
  const auto some = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const double scale = slope_scale<double>(u[k]);
      const Slope<double> s = slope<double>(u[k], scale);
      const double reach = std::sqrt(1 + s.a * s.a + s.b * s.b);
      results[k] = finish(u[k], scale, NormalQuery{s, reach, sine * sine});
    }
  };
  const double visits = std::sqrt(static_cast<double>(size_ + 1));
  const auto grain = static_cast<std::size_t>(std::ceil(kTaskVisits / visits));
  const tbb::blocked_range<std::size_t> all(0, u.size(), grain);
  all.is_divisible() ? tbb::parallel_for(all, some) : some(all);
}

void NormalTree::values(std::span<const Vector3> u, std::span<double> h, double resolution) const {
  evaluate(u, h, resolution, [this](const Vector3& w, double scale, const NormalQuery& query) {
    TwoSum part{};
    kernels_->values(*nodes_, query, &part);
    return value_from_negative(total_, w, scale, part.value());
  });
}

void NormalTree::cuts(std::span<const Vector3> u, std::span<Vector3> g, double resolution) const {
  evaluate(u, g, resolution, [this](const Vector3&, double scale, const NormalQuery& query) {
    TwoSum sum[3] = {};
    kernels_->cuts(*nodes_, query, sum);
    return cut_from_negative(total_, scale, {sum[0].value(), sum[1].value(), sum[2].value()});
  });
}

bool NormalTree::worthwhile(std::size_t vectors, std::size_t directions) {
  // Measured on smooth meshes (Zen 5, AVX-512). Few directions leave the flat sum waiting for its
  // additions, so the tree overtakes it earlier.
  if (directions == 1) return vectors >= 1000;
  return vectors >= (directions < 8 ? 2000 : 4000);
}

std::size_t NormalTree::bytes() const {
  return sizeof(*this) + sizeof(NormalNodes) + doubles_ * sizeof(double);
}

}  // namespace rectilin

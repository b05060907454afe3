// Answers queries of a direction tree, spread over threads.
#include "rectilin/measure/direction_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "tree/direction_tree_kernels.h"
#include "tree/twig.h"

namespace rectilin {
namespace {

// Least number of nodes for a task to visit, estimated as the square root of the number of vectors for each direction:
// some 20 microseconds of work.
constexpr double kTaskVisits = 8192;

// Number of directions in one pass, on the stack.
constexpr std::size_t kQueriesPerPass = 1024;

}  // namespace

template <class Result, class Walk, class Flat>
void DirectionTree::evaluate(std::span<const Vector3> u, std::span<Result> results, double resolution, const Walk& walk,
                             const Flat& flat) const {
  assert(u.size() == results.size());
  const double sine = std::sin(resolution);
  const double visits = std::sqrt(static_cast<double>(size() + 1));
  const auto grain = static_cast<std::size_t>(std::ceil(kTaskVisits / visits));
  std::array<bool, kQueriesPerPass> done;
  std::array<Vector3, kQueriesPerPass> left;
  std::array<Result, kQueriesPerPass> found;
  for (std::size_t pass = 0; pass < u.size(); pass += kQueriesPerPass) {
    const tbb::blocked_range<std::size_t> all(0, std::min(kQueriesPerPass, u.size() - pass), grain);
    const auto some = [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t k = range.begin(); k < range.end(); ++k) {
        const Vector3& w = u[pass + k];
        const double scale = slope_scale<double>(w);
        const Slope<double> s = slope<double>(w, scale);
        const double reach = std::sqrt(1 + s.a * s.a + s.b * s.b);
        done[k] =
            walk(w, scale, DirectionQuery{.slope = s, .reach = reach, .resolution = sine * sine}, results[pass + k]);
      }
    };
    all.is_divisible() ? tbb::parallel_for(all, some) : some(all);

    // The directions that are left to the flat sum go there in one batch.
    std::size_t count = 0;
    for (std::size_t k = 0; k < all.end(); ++k)
      if (!done[k]) left[count++] = u[pass + k];
    if (count == 0) continue;
    flat(std::span<const Vector3>(left.data(), count), std::span<Result>(found.data(), count));
    for (std::size_t k = all.end(); k-- > 0;)
      if (!done[k]) results[pass + k] = found[--count];
  }
}

void DirectionTree::values(std::span<const Vector3> u, std::span<double> h, double resolution) const {
  const Twig* const twigs = resolution > 0 ? nullptr : twigs_->get(*nodes_);
  evaluate(
      u, h, resolution,
      [this, twigs](const Vector3& w, double scale, DirectionQuery query, double& value) {
        query.twigs = twigs;
        TwoSum part{};
        const bool done = kernels_->values(*nodes_, query, &part);
        if (done) value = value_from_negative(total_, w, scale, part.value());
        return done;
      },
      [this](auto w, auto values) { flat_.values(w, values); });
}

void DirectionTree::cuts(std::span<const Vector3> u, std::span<Vector3> g, double resolution) const {
  evaluate(
      u, g, resolution,
      [this](const Vector3&, double scale, const DirectionQuery& query, Vector3& cut) {
        TwoSum sum[3] = {};
        const bool done = kernels_->cuts(*nodes_, query, sum);
        if (done) cut = cut_from_negative(total_, scale, {sum[0].value(), sum[1].value(), sum[2].value()});
        return done;
      },
      [this](auto w, auto cuts) { flat_.cuts(w, cuts); });
}

bool DirectionTree::worthwhile(std::size_t vectors) {
  // Measured (papers/throughput.md): from here on the tree is twice as fast as the flat sum on smooth meshes, and takes
  // at most 1.15 times as long for a direction that is orthogonal to all vectors.
  return vectors >= 30000;
}

std::size_t DirectionTree::bytes() const {
  return sizeof(*this) + sizeof(DirectionTreeNodes) + bytes_ + twigs_->bytes();
}

}  // namespace rectilin

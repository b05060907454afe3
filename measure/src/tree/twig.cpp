// Makes the twigs of a direction tree from its families and leaves.
#include "tree/twig.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "rectilin/base/ceil_div.h"
#include "tree/family.h"
#include "tree/storage.h"

namespace rectilin {
namespace {

Vector3 vector(const DirectionLeaf& leaf, std::size_t i, std::uint64_t unit) {
  const auto component = [&](std::size_t c) { return 256.0 * leaf.high[c][i] + leaf.low[c][i]; };
  return std::bit_cast<double>((unit - leaf.exponent[i]) << 52) * Vector3(component(0), component(1), component(2));
}

/// The axis along which a sum is longest, and the others in their order.
struct Axes {
  int longest, first, second;

  explicit Axes(const Vector3& sum) {
    const double x = std::abs(sum.x()), y = std::abs(sum.y()), z = std::abs(sum.z());
    longest = x >= std::max(y, z) ? 0 : z > std::max(x, y) ? 2 : 1;
    first = longest == 0 ? 1 : 0;
    second = longest == 2 ? 1 : 2;
  }
};

/// w = share (V + p e + q f)
struct Place {
  double share = 0, p = 0, q = 0;
};

/// All zeros for the zero vector. (Other vectors of a narrow node point to the side of its sum.)
Place place(const Vector3& w, const Vector3& sum, const Axes& axes) {
  if (w[axes.longest] == 0) return {};
  const double inverse = sum[axes.longest] / w[axes.longest], reciprocal = 1 / sum[axes.longest];
  return {w[axes.longest] * reciprocal, w[axes.first] * inverse - sum[axes.first],
          w[axes.second] * inverse - sum[axes.second]};
}

/// The integer next to `x`, at least zero and at most `most`. (Library functions that round are calls without SSE4.)
std::int64_t whole(double x, double most) { return static_cast<std::int64_t>(std::clamp(x + 0.5, 0.0, most)); }

void fill_vectors(const DirectionLeaf& leaf, std::uint64_t unit, const Node& node, const Axes& axes,
                  std::uint64_t* vectors) {
  const double scale = 1 / (kVectorStep * node.radius);
  for (std::size_t i = 0; i < kLeaf; ++i) {
    const Place w = place(vector(leaf, i, unit), node.sum, axes);
    const auto share = whole(w.share / kVectorShare, 1 / kVectorShare - 1);
    const auto p = whole(kMiddle + w.p * scale, 2 * kMiddle - 1), q = whole(kMiddle + w.q * scale, 2 * kMiddle - 1);
    vectors[i] = static_cast<std::uint64_t>(share << 2 * kStepBits | q << kStepBits | p);
  }
}

/// Writes a leaf's sum and cap and returns them as they can be read again.
Node fill_sum(const Node& leaf, const Node& parent, const Axes& axes, Twig& twig, std::size_t j) {
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  const double step = kNodeStep * parent.radius;
  const Place sum = place(leaf.sum, parent.sum, axes);
  const auto steps = [step](double x) {
    return static_cast<std::int32_t>(whole(kMost + x / step, 2.0 * kMost) - kMost);
  };
  twig.shares[j] = static_cast<std::int32_t>(whole(sum.share / kNodeShare, kMost));
  twig.first[j] = steps(sum.p);
  twig.second[j] = steps(sum.q);
  // Rounding turns the sum by up to a step, and the cap has to hold the vectors still.
  const double ratio = leaf.radius / parent.radius + 8 * kNodeStep;
  twig.radii[j] = std::nextafter(static_cast<float>(ratio), std::numeric_limits<float>::infinity());
  Node result{parent.sum, parent.radius * twig.radii[j]};
  result.sum[axes.first] += step * twig.first[j];
  result.sum[axes.second] += step * twig.second[j];
  result.sum *= kNodeShare * twig.shares[j];
  return result;
}

/// What queries of random directions may expect of twigs.
struct TwigStatistics {
  double widths = 0;     ///< mean sum of |V| sin(radius) over the leaves that a circle meets
  std::size_t wide = 0;  ///< number of nodes that are not narrow

  TwigStatistics& operator+=(const TwigStatistics& other) {
    widths += other.widths;
    wide += other.wide;
    return *this;
  }
};

TwigStatistics fill_twig(const DirectionTreeNodes& nodes, std::size_t index, std::size_t leaf_count, Twig& twig) {
  twig = {};
  const Node parent = load_node(nodes.levels[1][index / kFan], index % kFan);
  const Axes axes(parent.sum);
  TwigStatistics result;
  if (kNarrow * parent.radius > std::abs(parent.sum[axes.longest])) return {.wide = 1};
  if (parent.radius == 0) return {};  // all vectors are zero
  for (std::size_t j = 0; j < kFan && kFan * index + j < leaf_count; ++j) {
    const Node leaf = fill_sum(load_node(nodes.levels[0][index], j), parent, axes, twig, j);
    if (twig.shares[j] == 0) continue;
    fill_vectors(nodes.leaves[kFan * index + j], nodes.unit, leaf, axes, twig.vectors[j]);
    result.widths += leaf.radius * std::min(1.0, leaf.radius / leaf.sum.norm());  // times the chance to be met
  }
  return result;
}

/// Fills the twigs of the first `count` nodes of level 1.
TwigStatistics fill_twigs(const DirectionTreeNodes& nodes, std::size_t leaf_count, Twig* twigs, std::size_t count) {
  constexpr std::size_t kGrain = 256;
  return tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, count, kGrain), TwigStatistics(),
      [&](const tbb::blocked_range<std::size_t>& range, TwigStatistics sum) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) sum += fill_twig(nodes, i, leaf_count, twigs[i]);
        return sum;
      },
      [](TwigStatistics a, const TwigStatistics& b) { return a += b; });
}

}  // namespace

const Twig* LazyTwigs::get(const DirectionTreeNodes& nodes) {
  // Isolated, or this thread could take a task of someone else who then waits here for it.
  std::call_once(once_, [&] { tbb::this_task_arena::isolate([&] { make(nodes); }); });
  return reinterpret_cast<const Twig*>(storage_.get());
}

/// Keeps the twigs unless their error leaves little margin where circles meet them in the mean, or many nodes are wide.
void LazyTwigs::make(const DirectionTreeNodes& nodes) {
  constexpr double kMargin = 1.25;
  constexpr std::size_t kWideShare = 8;
  if (leaf_count_ == 0) return;
  const std::size_t count = ceil_div(leaf_count_, kFan), bytes = count * sizeof(Twig);
  auto storage = allocate_nodes(bytes);
  const TwigStatistics expected = fill_twigs(nodes, leaf_count_, reinterpret_cast<Twig*>(storage.get()), count);
  if (kMargin * expected.widths > nodes.widths || kWideShare * expected.wide > count) return;
  storage_ = std::move(storage);
  bytes_ = bytes;
}

}  // namespace rectilin

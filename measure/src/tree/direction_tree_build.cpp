// Builds a direction tree from the leaves upwards.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rectilin/base/ceil_div.h"
#include "rectilin/measure/direction_tree.h"
#include "sums/cap.h"
#include "tree/direction_tree_kernels.h"
#include "tree/family.h"
#include "tree/leaf_kernels.h"
#include "tree/storage.h"
#include "tree/twig.h"
#include "vectors/kd_order.h"

namespace rectilin {
namespace {

// A task works on nodes that cover this many leaves, or on a single larger node.
constexpr std::size_t kTaskLeaves = 2048;

// A query gives up when it meets more than this share of a level's nodes (1 in 8). Opening a node takes as long as
// adding 50 to 100 vectors in the flat sum, so an eighth of the leaves costs about as much as the flat sum. The few
// nodes of the upper levels tell little about the leaves and cost next to nothing: a 512th of the number of leaves, and
// at least kFewest, are always opened.
constexpr std::size_t kLargestShare = 8;
constexpr std::size_t kFreeShare = 512;
constexpr std::size_t kFewest = 96;

/// Fills all leaves with the vectors in k-d order and returns their sums. Runs have a fixed length, so that order and
/// signs do not depend on the number of threads.
std::vector<Vector3> fill_runs(const AreaVectors& vectors, DirectionLeaf* leaves, std::size_t count,
                               std::uint64_t unit) {
  std::vector<Vector3> sums(count);
  const VectorSpan<double> all{vectors.x.data(), vectors.y.data(), vectors.z.data(), vectors.size()};
  tbb::parallel_for(std::size_t{0}, ceil_div(count * kLeaf, kRun), [&](std::size_t part) {
    const std::size_t begin = part * kRun, leaf = begin / kLeaf;
    const std::size_t size = std::min(kRun, all.size - begin);
    const std::vector<double> run = arranged(all.slice(begin, begin + size));
    fill_leaves({run.data(), run.data() + size, run.data() + 2 * size, size}, unit, leaves + leaf, sums.data() + leaf);
  });
  return sums;
}

/// Fills the nodes of one level, each over `stride` leaves: their sums, and the caps around all their vectors.
void fill_level(const DirectionTreeKernels& kernels, const DirectionTreeNodes& nodes, std::size_t leaf_count,
                const std::vector<Vector3>& sums, std::size_t stride, DirectionFamily* level) {
  const std::size_t grain = std::max<std::size_t>(1, kTaskLeaves / stride);
  const tbb::blocked_range<std::size_t> all(0, sums.size(), grain);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t node = range.begin(); node < range.end(); ++node) {
      const Vector3& v = sums[node];
      const Vector3 axis = v.stableNormalized();
      const std::size_t begin = node * stride, end = std::min(begin + stride, leaf_count);
      const double radius = cap_radius(v.norm(), kernels.cap(nodes, begin, end, axis.data()));
      store_node(level[node / kFan], node % kFan, {v, radius});
    }
  });
  for (std::size_t node = sums.size(); node % kFan != 0; ++node)
    store_node(level[node / kFan], node % kFan, {Vector3::Zero(), 0});
}

/// The sums of the next level up, of kFan nodes each.
std::vector<Vector3> parents(const std::vector<Vector3>& sums) {
  std::vector<Vector3> result(ceil_div(sums.size(), kFan), Vector3::Zero());
  for (std::size_t i = 0; i < sums.size(); ++i) result[i / kFan] += sums[i];
  return result;
}

/// How many nodes over `stride` leaves each a query may open.
std::size_t open_limit(std::size_t leaves, std::size_t stride) {
  const std::size_t share = ceil_div(leaves, stride * kLargestShare);
  return std::clamp(std::max(share, leaves / kFreeShare), kFewest, kMostOpened);
}

/// Number of families on each level, from the leaves upwards.
std::vector<std::size_t> level_sizes(std::size_t leaves) {
  std::vector<std::size_t> families = {ceil_div(leaves, kFan)};
  while (families.back() > 1) families.push_back(ceil_div(families.back(), kFan));
  return families;
}

}  // namespace

DirectionTree::DirectionTree(const AreaVectors& vectors, const TwigRule& twigs)
    : flat_(vectors), kernels_(&normal_kernels()) {
  const std::size_t leaf_count = std::max<std::size_t>(1, ceil_div(size(), kLeaf));
  const std::vector<std::size_t> families = level_sizes(leaf_count);
  bytes_ = leaf_count * sizeof(DirectionLeaf);
  for (const std::size_t count : families) bytes_ += count * sizeof(DirectionFamily);
  storage_ = allocate_nodes(bytes_);
  auto* leaves = reinterpret_cast<DirectionLeaf*>(storage_.get());
  auto* level = reinterpret_cast<DirectionFamily*>(leaves + leaf_count);

  auto nodes = std::make_shared<DirectionTreeNodes>();
  nodes->leaves = leaves;
  nodes->unit = leaf_unit(vectors.total);
  std::vector<Vector3> sums = fill_runs(vectors, leaves, leaf_count, nodes->unit);
  std::size_t stride = 1;
  for (const std::size_t count : families) {
    fill_level(*kernels_, *nodes, leaf_count, sums, stride, level);
    nodes->limits[nodes->depth] = open_limit(leaf_count, stride);
    nodes->levels[nodes->depth++] = level;
    level += count;
    stride *= kFan;
    sums = parents(sums);
  }
  total_ = sums.front();
  nodes->widths = twigs.error * vectors.total / kTwigError;
  nodes_ = std::move(nodes);
  twigs_ = std::make_shared<LazyTwigs>(size() >= twigs.fewest && nodes_->depth > 1 ? leaf_count : 0);
}

}  // namespace rectilin

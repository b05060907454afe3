// Builds a normal tree bottom up.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "normal_kernels.h"
#include "normal_storage.h"
#include "rectilin/measure/normal_tree.h"

namespace rectilin {
namespace {

// Rounding of a cap's sine, generously. What it does not cover would be harmless too: a vector
// misjudged by rounding lies within rounding of the great circle, so that its u . v is itself of
// the size of a rounding error.
constexpr double kSlack = 0x1p-50;

// Leaves that are copied by one task: those under one node of level 4.
constexpr std::size_t kRunLeaves = kFan * kFan * kFan * kFan;

// Tasks work on nodes that cover this many leaves or a single one.
constexpr std::size_t kTaskLeaves = 2048;

// The share of a level's nodes beyond which a query gives up. Opening a node takes the time in which
// the flat sum adds 50 to 100 vectors; so an eighth of the leaves costs about what the flat sum
// costs. The few nodes of the upper levels promise less about the leaves and cost next to nothing:
// as many as a 512th of the leaves, at least kFewest, are always opened.
constexpr std::size_t kLargestShare = 8;
constexpr std::size_t kFreeShare = 512;
constexpr std::size_t kFewest = 96;

std::size_t ceil_div(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

/// Copies one run of vectors into leaf after leaf, padded with zeros. Signs carry no meaning, but
/// vectors that are neighbours up to sign must point the same way for their sum to stand for them:
/// each vector is turned to the side of the one before it, the first to that of an arbitrary axis.
void copy_run(const AreaVectors& vectors, std::size_t first_leaf, std::size_t last_leaf,
              double* leaves) {
  Vector3 before(0.48, 0.36, 0.8);
  for (std::size_t leaf = first_leaf; leaf < last_leaf; ++leaf) {
    double* out = leaves + leaf * kLeafSpan;
    for (std::size_t j = 0; j < kLeaf; ++j) {
      const std::size_t i = leaf * kLeaf + j;
      Vector3 v = i < vectors.size() ? vectors[i] : Vector3::Zero();
      if (before.dot(v) < 0) v = -v;
      for (std::size_t c = 0; c < 3; ++c) out[c * kLeaf + j] = v[c];
      if (!v.isZero(0)) before = v;
    }
  }
}

/// All leaves. Runs are of fixed length, so that the signs do not depend on the number of threads.
void interleave(const AreaVectors& vectors, double* leaves, std::size_t count) {
  tbb::parallel_for(std::size_t{0}, ceil_div(count, kRunLeaves), [&](std::size_t run) {
    const std::size_t begin = run * kRunLeaves;
    copy_run(vectors, begin, std::min(begin + kRunLeaves, count), leaves);
  });
}

/// The sum of a leaf's vectors or a family's nodes, which start alike.
Vector3 sum(const double* group) {
  static_assert(kLeaf == kFan);
  Vector3 v = Vector3::Zero();
  for (std::size_t i = 0; i < kFan; ++i) {
    v += Vector3(group[i], group[kFan + i], group[2 * kFan + i]);
  }
  return v;
}

void set_node(double* level, std::size_t node, const Vector3& v, double radius) {
  double* out = level + node / kFan * kFamily + node % kFan;
  for (std::size_t c = 0; c < 3; ++c) out[c * kFan] = v[c];
  out[3 * kFan] = radius;
}

/// The nodes of one level: the sums of their children, and caps around all vectors under them.
/// `stride` is the number of leaves under a node.
void fill_level(const NormalKernels& kernels, const double* leaves, std::size_t leaf_count,
                const double* children, std::size_t stride, double* level) {
  const std::size_t size = ceil_div(leaf_count, stride);
  const std::size_t child_span = stride == 1 ? kLeafSpan : kFamily;
  const std::size_t grain = std::max<std::size_t>(1, kTaskLeaves / stride);
  const tbb::blocked_range<std::size_t> all(0, size, grain);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t node = range.begin(); node < range.end(); ++node) {
      const Vector3 v = sum(children + node * child_span);
      const Vector3 axis = v.stableNormalized();
      const std::size_t begin = node * stride, count = std::min(stride, leaf_count - begin);
      const double sine = std::sqrt(kernels.cap(leaves + begin * kLeafSpan, count, axis.data()));
      set_node(level, node, v, std::isinf(sine) ? sine : v.norm() * (sine + kSlack));
    }
  });
  for (std::size_t node = size; node % kFan != 0; ++node) {
    set_node(level, node, Vector3::Zero(), -1);
  }
}

/// Nodes over `stride` leaves each that a query may open.
std::size_t open_limit(std::size_t leaves, std::size_t stride) {
  const std::size_t share = ceil_div(leaves, stride * kLargestShare);
  return std::clamp(std::max(share, leaves / kFreeShare), kFewest, kMostOpened);
}

/// Numbers of families on all levels, from the leaves upwards.
std::vector<std::size_t> level_sizes(std::size_t leaves) {
  std::vector<std::size_t> families = {ceil_div(leaves, kFan)};
  while (families.back() > 1) families.push_back(ceil_div(families.back(), kFan));
  return families;
}

}  // namespace

NormalTree::NormalTree(const AreaVectors& vectors) : flat_(vectors), kernels_(&normal_kernels()) {
  const std::size_t leaves = std::max<std::size_t>(1, ceil_div(size(), kLeaf));
  const std::vector<std::size_t> families = level_sizes(leaves);
  doubles_ = leaves * kLeafSpan;
  for (const std::size_t count : families) doubles_ += count * kFamily;
  storage_ = allocate_nodes(doubles_);
  interleave(vectors, storage_.get(), leaves);

  auto nodes = std::make_shared<NormalNodes>();
  nodes->leaves = storage_.get();
  const double* children = nodes->leaves;
  double* level = storage_.get() + leaves * kLeafSpan;
  std::size_t stride = 1;
  for (const std::size_t count : families) {
    fill_level(*kernels_, nodes->leaves, leaves, children, stride, level);
    nodes->limits[nodes->depth] = open_limit(leaves, stride);
    nodes->levels[nodes->depth++] = level;
    children = level;
    level += count * kFamily;
    stride *= kFan;
  }
  total_ = sum(children);
  nodes_ = std::move(nodes);
}

}  // namespace rectilin

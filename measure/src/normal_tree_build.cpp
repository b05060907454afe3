// Builds a normal tree bottom up.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
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

// Tasks work on nodes that cover this many leaves or a single one.
constexpr std::size_t kTaskLeaves = 2048;

std::size_t ceil_div(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

/// Copies vectors, padded with zeros, into leaf after leaf.
void interleave(const AreaVectors& vectors, double* leaves, std::size_t count) {
  const std::array<const double*, 3> components = {vectors.x.data(), vectors.y.data(),
                                                   vectors.z.data()};
  const tbb::blocked_range<std::size_t> all(0, count, kTaskLeaves);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t leaf = range.begin(); leaf < range.end(); ++leaf) {
      const std::size_t begin = leaf * kLeaf, end = std::min(begin + kLeaf, vectors.size());
      double* out = leaves + leaf * kLeafSpan;
      for (const double* component : components) {
        std::fill(std::copy(component + begin, component + end, out), out + kLeaf, 0.0);
        out += kLeaf;
      }
    }
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

/// Numbers of families on all levels, from the leaves upwards.
std::vector<std::size_t> level_sizes(std::size_t leaves) {
  std::vector<std::size_t> families = {ceil_div(leaves, kFan)};
  while (families.back() > 1) families.push_back(ceil_div(families.back(), kFan));
  return families;
}

}  // namespace

NormalTree::NormalTree(const AreaVectors& vectors)
    : size_(vectors.size()), kernels_(&normal_kernels()) {
  const std::size_t leaves = std::max<std::size_t>(1, ceil_div(size_, kLeaf));
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
    nodes->levels[nodes->depth++] = level;
    children = level;
    level += count * kFamily;
    stride *= kFan;
  }
  total_ = sum(children);
  nodes_ = std::move(nodes);
}

}  // namespace rectilin

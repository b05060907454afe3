// Builds a normal tree bottom up and spreads queries over threads.
#include "rectilin/measure/normal_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "normal_kernels.h"

namespace rectilin {
namespace {

constexpr std::size_t kGrain = 16;
constexpr double kSlack = 0x1p-50;

std::size_t ceil_div(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

AlignedDoubles interleave(const AreaVectors& vectors) {
  const std::size_t count = ceil_div(vectors.size(), kLeaf);
  AlignedDoubles leaves(count * kLeafSpan);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t leaf = range.begin(); leaf < range.end(); ++leaf) {
      const std::size_t begin = leaf * kLeaf, end = std::min(begin + kLeaf, vectors.size());
      double* out = &leaves[leaf * kLeafSpan];
      std::copy(&vectors.x[begin], vectors.x.data() + end, out);
      std::copy(&vectors.y[begin], vectors.y.data() + end, out + kLeaf);
      std::copy(&vectors.z[begin], vectors.z.data() + end, out + 2 * kLeaf);
    }
  });
  return leaves;
}

/// The sum of one leaf's vectors, or of one family's nodes.
template <std::size_t kSize>
Vector3 sum(const double* group) {
  Vector3 v = Vector3::Zero();
  for (std::size_t i = 0; i < kSize; ++i) {
    v += Vector3(group[i], group[kSize + i], group[2 * kSize + i]);
  }
  return v;
}

}  // namespace

NormalTree::NormalTree(const AreaVectors& vectors)
    : size_(vectors.size()), kernels_(&normal_kernels()), leaves_(interleave(vectors)) {
  const std::size_t leaves = leaves_.size() / kLeafSpan;
  std::size_t below = leaves;  // nodes of this level
  std::size_t stride = 1;      // leaves per node
  do {
    const std::size_t families = std::max<std::size_t>(1, ceil_div(below, kFan));
    AlignedDoubles level(families * kFamily);
    const double* children = levels_.empty() ? leaves_.data() : levels_.back().data();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, below), [&](const auto& range) {
      for (std::size_t node = range.begin(); node < range.end(); ++node) {
        const Vector3 v = levels_.empty() ? sum<kLeaf>(children + node * kLeafSpan)
                                          : sum<kFan>(children + node * kFamily);
        const std::size_t begin = node * stride, count = std::min(stride, leaves - begin);
        const double sine = kernels_->cap(&leaves_[begin * kLeafSpan], count, v.data());
        double* out = &level[node / kFan * kFamily + node % kFan];
        for (int c = 0; c < 3; ++c) out[c * kFan] = v[c];
        out[3 * kFan] = v.norm() * (std::sqrt(sine) + kSlack);
      }
    });
    for (std::size_t node = below; node < families * kFan; ++node) level[node / kFan * kFamily + 3 * kFan + node % kFan] = -1;
    levels_.push_back(std::move(level));
    below = families;
    stride *= kFan;
  } while (below > 1);
  total_ = sum<kFan>(levels_.back().data());
}

void NormalTree::values(std::span<const Vector3> u, std::span<double> h, double resolution) const {
  NormalNodes nodes{leaves_.data(), {}, static_cast<int>(levels_.size())};
  for (std::size_t i = 0; i < levels_.size(); ++i) nodes.levels[i] = levels_[i].data();
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double scale = slope_scale<double>(u[k]);
    const double sine = std::sin(resolution);
    const NormalQuery q{slope<double>(u[k], scale), u[k].norm() / std::abs(scale), sine * sine};
    TwoSum s{};
    kernels_->values(nodes, q, &s);
    h[k] = std::max(0.0, std::copysign(1.0, scale) * total_.dot(u[k]) - 2 * std::abs(scale) * s.value());
  }
}

void NormalTree::cuts(std::span<const Vector3> u, std::span<Vector3> g, double resolution) const {
  NormalNodes nodes{leaves_.data(), {}, static_cast<int>(levels_.size())};
  for (std::size_t i = 0; i < levels_.size(); ++i) nodes.levels[i] = levels_[i].data();
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double scale = slope_scale<double>(u[k]);
    const double sine = std::sin(resolution);
    const NormalQuery q{slope<double>(u[k], scale), u[k].norm() / std::abs(scale), sine * sine};
    TwoSum s[3] = {};
    kernels_->cuts(nodes, q, s);
    g[k] = std::copysign(1.0, scale) * (total_ - 2 * Vector3(s[0].value(), s[1].value(), s[2].value()));
  }
}

std::size_t NormalTree::bytes() const {
  std::size_t doubles = leaves_.capacity();
  for (const auto& level : levels_) doubles += level.capacity();
  return sizeof(*this) + doubles * sizeof(double);
}

}  // namespace rectilin

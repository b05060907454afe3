#include "rectilin/measure/projected_area.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

namespace rectilin {
namespace {

/// Number of rotations in one pass: enough to keep all threads busy, few enough for the stack and the cache.
constexpr std::size_t kRotationsPerPass = 256;

}  // namespace

ProjectedArea::ProjectedArea(AreaVectors vectors, std::string name, SumMethod method, Precision precision)
    : vectors_(std::move(vectors)),
      flat_(vectors_, precision),
      use_tree_(method == SumMethod::kTree ||
                (method == SumMethod::kAuto && DirectionTree::worthwhile(vectors_.size()))),
      use_runs_(method == SumMethod::kAuto && precision == Precision::kDouble && RunSum::worthwhile(vectors_.size())),
      name_(std::move(name)) {}

const DirectionTree& ProjectedArea::tree() const {
  // Isolated, or this thread could meanwhile take a task of another that waits here for it.
  std::call_once(tree_once_, [this] { tbb::this_task_arena::isolate([this] { tree_.emplace(vectors_); }); });
  return *tree_;
}

const RunSum& ProjectedArea::runs() const {
  std::call_once(runs_once_, [this] { runs_.emplace(vectors_); });
  return *runs_;
}

void ProjectedArea::values(std::span<const Rotation> rotations, std::span<double> values) const {
  std::array<Vector3, 3 * kRotationsPerPass> directions;
  std::array<double, 3 * kRotationsPerPass> h;
  std::array<std::array<std::size_t, 3>, kRotationsPerPass>
      axes;  // where each rotation's axes are among the directions
  for (std::size_t begin = 0; begin < rotations.size(); begin += kRotationsPerPass) {
    const std::size_t count = std::min(kRotationsPerPass, rotations.size() - begin);
    std::size_t used = 0;
    for (std::size_t i = 0; i < count; ++i)
      for (int k = 0; k < 3; ++k) {
        const Vector3 axis = rotations[begin + i].axis(k);
        // Neighbours of a grid along gamma have the same third axis: h(r3) is summed once for the whole line.
        if (i > 0 && directions[axes[i - 1][k]] == axis) {
          axes[i][k] = axes[i - 1][k];
        } else {
          directions[used] = axis;
          axes[i][k] = used++;
        }
      }
    if (use_tree_) tree().values({directions.data(), used}, {h.data(), used});
    else if (use_runs_) runs().values({directions.data(), used}, {h.data(), used});
    else flat_.values({directions.data(), used}, {h.data(), used});
    for (std::size_t i = 0; i < count; ++i)
      values[begin + i] = (h[axes[i][0]] + h[axes[i][1]] + h[axes[i][2]]) / vectors_.total;
  }
}

void ProjectedArea::cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) const {
  std::array<Vector3, 3 * kRotationsPerPass> directions, subgradients;
  for (std::size_t begin = 0; begin < rotations.size(); begin += kRotationsPerPass) {
    const std::size_t count = std::min(kRotationsPerPass, rotations.size() - begin);
    for (std::size_t i = 0; i < 3 * count; ++i) directions[i] = rotations[begin + i / 3].axis(static_cast<int>(i % 3));
    if (use_runs_) runs().cuts({directions.data(), 3 * count}, {subgradients.data(), 3 * count});
    else if (use_tree_) tree().cuts({directions.data(), 3 * count}, {subgradients.data(), 3 * count});
    else flat_.cuts({directions.data(), 3 * count}, {subgradients.data(), 3 * count});
    for (std::size_t i = 0; i < count; ++i) {
      Cut& cut = cuts[begin + i];
      for (int k = 0; k < 3; ++k) cut.gradient.row(k) = subgradients[3 * i + k].transpose() / vectors_.total;
      cut.value = cut.gradient.cwiseProduct(rotations[begin + i].matrix()).sum();
    }
  }
}

CutBounds ProjectedArea::cut_bounds() const {
  // Two directions that were merged may be kParallel apart; dividing by S costs a few roundoffs.
  double sums = use_tree_ ? DirectionTree::kErrorBound : FlatSum::relative_error_bound(flat_.precision());
  constexpr DirectionTree::TwigRule kTwigs;
  if (use_tree_ && vectors_.size() >= kTwigs.fewest) sums += kTwigs.error;  // values are bounded by the same allowance
  if (use_runs_) sums = std::max(sums, RunSum::kErrorBound);
  return {.error = sums + 4 * kParallel, .norm = 1 + 1e-12, .floor = 1 - 0x1p-50};  // floor: eq. (12)
}

Generators ProjectedArea::generators() const { return {vectors_.x, vectors_.y, vectors_.z, 1 / vectors_.total}; }

}  // namespace rectilin

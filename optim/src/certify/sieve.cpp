#include "certify/sieve.h"

#include <algorithm>
#include <bit>

#include "certify/sieve_kernels.h"
#include "rectilin/base/rotation.h"

namespace rectilin::certification {
namespace {

// How often boxes are divided into octants: twice, and once more where at most this many of the eight are left.
constexpr int kLevels = 3, kFew = 4;

/// The cuts that may be the best for an axis on the box: those taken near where its corners and its middle point to,
/// as far as they may exceed the cell's own cuts.
CutList rivals(const Cell& cell, int k, const Corners& corners, const Rotation& middle, const CutTable& table) {
  const Eigen::Vector3d u = middle.axis(k);
  const double reach = 2 * cell.box.half_edges().norm();  // turns by an angle of a are at tan(a / 2)
  CutList list;
  Eigen::Vector3d known = table[cell.bundles[k].cuts[0]];
  for (int j = 0; j < cell.bundles[k].size; ++j) {
    const Eigen::Vector3d& slope = table[cell.bundles[k].cuts[j]];
    list.add(slope);
    if (slope.dot(u) > known.dot(u)) known = slope;
  }
  std::array<const CutTable::Square*, 9> seen;
  std::size_t count = 0;
  const auto look = [&](const Eigen::Vector3d& direction) {
    const CutTable::Square& square = table.square(direction);
    if (std::find(seen.begin(), seen.begin() + count, &square) != seen.begin() + count) return;
    seen[count++] = &square;
    for (const CutTable::Block& block : square.blocks) add_rivals(block, known, u, reach, list);
  };
  look(u);
  for (int c = 0; c < 8; ++c) look({corners.entry[3 * k][c], corners.entry[3 * k + 1][c], corners.entry[3 * k + 2][c]});
  return list;
}

Box octant(const Box& box, std::uint32_t number) {
  const Eigen::Vector3d middle = box.centre();
  Box part = box;
  for (int i = 0; i < 3; ++i) (number >> i & 1 ? part.lower : part.upper)[i] = middle[i];
  return part;
}

template <class F>
void for_each_bit(std::uint32_t bits, const F& f) {
  for (; bits != 0; bits &= bits - 1) f(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

}  // namespace

Halves sift(const Cell& cell, int axis, const CutTable& table, const Balls& balls, double enough) {
  const Corners corners(cell.box);
  const Rotation middle = rotation_from_rodrigues(cell.box.centre());
  const auto list = [&](int k) { return rivals(cell, k, corners, middle, table); };
  const std::array<CutList, 3> lists = {list(0), list(1), list(2)};
  const double border = cell.box.centre()[axis];
  Halves halves;
  const auto keep = [&](const Rest& part) {
    std::optional<Rest>& half = halves[part.box.lower[axis] < border ? 0 : 1];
    if (!half) {
      half = part;
      return;
    }
    half->box.lower = half->box.lower.cwiseMin(part.box.lower);
    half->box.upper = half->box.upper.cwiseMax(part.box.upper);
    half->bound = std::min(half->bound, part.bound);
    if (part.value < half->value) half->value = part.value, half->low_point = part.low_point;
  };
  const auto divide = [&](const auto& self, const Box& box, int level) -> void {
    const Octants octants = test_octants(box, lists, enough);
    const bool further = level == 1 || (level < kLevels && std::popcount(octants.open) <= kFew);
    for_each_bit(octants.open, [&](std::uint32_t number) {
      const Box part = octant(box, number);
      if (further) self(self, part, level + 1);
      else if (!balls.hold(part)) keep({part, octants.bound[number], octants.value[number], part.centre()});
    });
  };
  divide(divide, cell.box, 1);
  return halves;
}

}  // namespace rectilin::certification

#include "certify/sieve.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "certify/sieve_kernels.h"
#include "rectilin/base/rotation.h"

namespace rectilin::certification {
namespace {

// How often boxes are divided into octants: twice, and once more where at most this many of the eight are left.
constexpr int kLevels = 3, kFew = 6;

/// The smallest box that holds some octants of a box, which are given as bits.
Box hull(const Box& box, std::uint32_t octants) {
  constexpr std::uint32_t kUpper[] = {0b10101010, 0b11001100, 0b11110000};  // those in the upper half of each axis
  const Eigen::Vector3d middle = box.centre();
  Box part = box;
  for (int i = 0; i < 3; ++i) {
    if ((octants & kUpper[i]) == 0) part.upper[i] = middle[i];
    if ((octants & ~kUpper[i]) == 0) part.lower[i] = middle[i];
  }
  return part;
}

/// The hull of one octant, without branches, as there are many.
Box octant(const Box& box, std::uint32_t number) {
  Box part;
  for (int i = 0; i < 3; ++i) {
    const double ends[] = {box.lower[i], 0.5 * (box.lower[i] + box.upper[i]), box.upper[i]};
    const std::uint32_t side = number >> i & 1;
    part.lower[i] = ends[side], part.upper[i] = ends[side + 1];
  }
  return part;
}

template <class F>
void for_each_bit(std::uint32_t bits, const F& f) {
  for (; bits != 0; bits &= bits - 1) f(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

}  // namespace

Halves sift(const Cell& cell, int axis, const CutTable& table, const Balls& balls, double enough) {
  const Rotation middle = rotation_from_rodrigues(cell.box.centre());
  CutLists lists;
  find_rivals(cell, table, middle, lists);
  const double border = cell.box.centre()[axis];
  Halves halves;
  const auto keep = [&](const Box& box, const Octants& octants, std::uint32_t open) {
    std::optional<Rest>& half = halves[box.lower[axis] < border ? 0 : 1];
    const Box part = hull(box, open);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!half) half = {part, kInfinity, kInfinity, part.centre()};
    half->box.lower = half->box.lower.cwiseMin(part.lower);
    half->box.upper = half->box.upper.cwiseMax(part.upper);
    for_each_bit(open, [&](std::uint32_t number) {
      half->bound = std::min(half->bound, octants.bound[number]);
      if (octants.value[number] < half->value)
        half->value = octants.value[number], half->low_point = octant(box, number).centre();
    });
  };
  std::array<std::array<Box, 8 * kFew>, 2> memory;
  memory[0][0] = cell.box;
  std::size_t count = 1;
  for (int level = 1; count > 0; ++level) {
    const auto& boxes = memory[(level - 1) % 2];
    auto& parts = memory[level % 2];
    std::size_t further = 0;
    for (std::size_t begin = 0; begin < count; begin += kMostBoxes) {
      const std::span some(boxes.data() + begin, std::min(kMostBoxes, count - begin));
      std::array<Octants, kMostBoxes> results;
      test_octants(some, cell.box, lists, table, enough, results.data());
      for (std::size_t i = 0; i < some.size(); ++i) {
        std::uint32_t open = results[i].open;
        if (level == 1 || (level < kLevels && std::popcount(open) <= kFew)) {
          for_each_bit(open, [&](std::uint32_t number) { parts[further++] = octant(some[i], number); });
          continue;
        }
        if (!balls.empty())
          for_each_bit(open, [&](std::uint32_t number) {
            if (balls.hold(octant(some[i], number))) open &= ~(std::uint32_t{1} << number);
          });
        if (open) keep(some[i], results[i], open);
      }
    }
    count = further;
  }
  return halves;
}

}  // namespace rectilin::certification

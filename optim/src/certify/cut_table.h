// The cuts taken so far, and the best of them for a direction.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "certify/box.h"
#include "rectilin/optim/objective.h"

namespace rectilin::certification {

/// The rows of all cuts in the order in which they were taken. A row is a linear lower bound of h everywhere, so each
/// can be used for any axis.
///
/// Rows are also ordered by where on the sphere they were taken. The sphere is seen as a cube with kSide x kSide
/// squares on each face, and each square holds the latest rows that were taken at its directions. Reading is thread
/// safe.
class CutTable {
 public:
  static constexpr std::size_t kLanes = 8;

  /// Eight rows as a structure of arrays; the zeros of a block that is not full are valid, but useless.
  struct Block {
    std::array<Array8, 3> row = {Array8::Zero(), Array8::Zero(), Array8::Zero()};
    std::array<std::uint32_t, kLanes> index = {};
  };

  struct Square {
    std::vector<Block> blocks;
    std::uint32_t count = 0;

    void add(std::uint32_t index, const Eigen::Vector3d& row) {
      const std::uint32_t at = count++ % kKept, lane = at % kLanes;
      if (at / kLanes == blocks.size()) blocks.emplace_back();
      Block& block = blocks[at / kLanes];
      for (int i = 0; i < 3; ++i) block.row[i][lane] = row[i];
      block.index[lane] = index;
    }
  };

  CutTable() : squares_(6 * kSide * kSide) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }
  const Eigen::Vector3d& operator[](std::size_t i) const { return rows_[i]; }

  /// Adds the three rows of a cut that was taken at a rotation.
  void add(const Rotation& rotation, const Cut& cut) {
    for (int k = 0; k < 3; ++k) {
      squares_[square_of(rotation.axis(k))].add(size(), cut.gradient.row(k));
      rows_.push_back(cut.gradient.row(k));
    }
  }

  /// The rows that were taken near a direction, which need not have length one.
  const Square& square(const Eigen::Vector3d& u) const { return squares_[square_of(u)]; }

  struct Found {
    double value;
    std::uint32_t row = 0;
  };

  /// The row with the largest product with u, which need not have length one, among those in u's square, if that
  /// product exceeds `value`. Otherwise this value.
  Found best(const Eigen::Vector3d& u, double value) const {
    Found found = {value};
    for (const Block& block : squares_[square_of(u)].blocks) {
      const Array8 values = u[0] * block.row[0] + u[1] * block.row[1] + u[2] * block.row[2];
      if (!(values > found.value).any()) continue;
      int lane = 0;
      found.value = values.maxCoeff(&lane);
      found.row = block.index[static_cast<std::size_t>(lane)];
    }
    return found;
  }

 private:
  static constexpr int kSide = 5;
  static constexpr std::uint32_t kKept = 128;

  static std::size_t square_of(const Eigen::Vector3d& u) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(u[i]) > std::abs(u[axis])) axis = i;
    const double scale = 0.5 * kSide / std::abs(u[axis]);
    const auto column = [&](int i) { return std::min(kSide - 1, static_cast<int>(scale * u[i] + 0.5 * kSide)); };
    const int face = 2 * axis + (u[axis] < 0);
    return static_cast<std::size_t>((face * kSide + column((axis + 1) % 3)) * kSide + column((axis + 2) % 3));
  }

  std::vector<Eigen::Vector3d> rows_;
  std::vector<Square> squares_;
};

}  // namespace rectilin::certification

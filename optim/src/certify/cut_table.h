// The cuts taken so far, and the best of them for a direction.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
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
  static constexpr std::size_t kLanes = 16;
  static constexpr int kSide = 3;
  static constexpr std::size_t kSquares = 6 * kSide * kSide;

  /// Some rows as a structure of arrays, to choose among them: each number is the sum of two in single precision. Where
  /// a block is not full there are zeros, and the number of the first row.
  struct Block {
    using Component = Eigen::Array<float, kLanes, 1>;
    std::array<Component, 3> row = {Component::Zero(), Component::Zero(), Component::Zero()}, rest = row;
    std::array<std::uint32_t, kLanes> index = {};
  };

  struct Square {
    std::vector<Block> blocks;
    std::uint32_t count = 0;  ///< of rows that were added, the earliest of which may have been replaced

    std::size_t size() const { return std::min(count, kKept); }

    void add(std::uint32_t index, const Eigen::Vector3d& row) {
      const std::uint32_t at = count++ % kKept, lane = at % kLanes;
      if (at / kLanes == blocks.size()) blocks.emplace_back();
      Block& block = blocks[at / kLanes];
      for (int i = 0; i < 3; ++i) {
        block.row[i][lane] = static_cast<float>(row[i]);
        block.rest[i][lane] = static_cast<float>(row[i] - block.row[i][lane]);
      }
      block.index[lane] = index;
    }
  };

  CutTable() : squares_(kSquares) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }
  Eigen::Map<const Eigen::Vector3d> operator[](std::size_t i) const {
    return Eigen::Map<const Eigen::Vector3d>(data(i));
  }

  /// The three components of a row, and a zero.
  const double* data(std::size_t i) const { return rows_[i].data(); }

  /// Adds the three rows of a cut that was taken at a rotation.
  void add(const Rotation& rotation, const Cut& cut) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d row = cut.gradient.row(k);
      squares_[square_of(rotation.axis(k))].add(size(), row);
      rows_.push_back({row[0], row[1], row[2], 0});
    }
  }

  const Square& square(std::size_t number) const { return squares_[number]; }

  /// The number of the square that holds the rows taken near a direction, which need not have length one.
  static std::size_t square_of(const Eigen::Vector3d& u) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(u[i]) > std::abs(u[axis])) axis = i;
    const double scale = 0.5 * kSide / std::abs(u[axis]);
    const auto column = [&](int i) { return std::min(kSide - 1, static_cast<int>(scale * u[i] + 0.5 * kSide)); };
    const int face = 2 * axis + (u[axis] < 0);
    return static_cast<std::size_t>((face * kSide + column((axis + 1) % 3)) * kSide + column((axis + 2) % 3));
  }

  struct Found {
    double value;
    std::uint32_t row = 0;
  };

  /// The row with the largest product with u, which need not have length one, among those in u's square (in single
  /// precision), if that product exceeds `value`. Otherwise this value.
  Found best(const Eigen::Vector3d& u, double value) const {
    Found found = {value};
    float most = std::numeric_limits<float>::lowest();
    const Eigen::Vector3f v = u.cast<float>();
    for (const Block& block : squares_[square_of(u)].blocks) {
      const Block::Component values = v[0] * block.row[0] + v[1] * block.row[1] + v[2] * block.row[2];
      if (!(values > most).any()) continue;
      int lane = 0;
      most = values.maxCoeff(&lane);
      const std::uint32_t row = block.index[static_cast<std::size_t>(lane)];
      const double exact = u.dot((*this)[row]);
      if (exact > found.value) found = {exact, row};
    }
    return found;
  }

 private:
  static constexpr std::uint32_t kKept = 256;

  std::vector<std::array<double, 4>> rows_;
  std::vector<Square> squares_;
};

}  // namespace rectilin::certification

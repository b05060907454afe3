#include "certify/descent.h"

#include <Eigen/Geometry>

#include "certify/corner_game.h"

namespace rectilin::certification {
namespace {

constexpr double kLargestRadius = 0.2, kSmallestRadius = 1e-13;  // radians

/// The cuts of each axis that the model of the objective keeps.
class Model {
 public:
  explicit Model(const Cut& cut) { add(cut, {}); }

  /// The minimum of the model over a cube of turns, as a corner game: to first order, turning the frame by t changes
  /// the value of a cut g at the axis r by t . (r x g).
  Strategies minimum(const Rotation& at, double radius) const {
    CornerGame game;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < size_[k]; ++j) {
        const Eigen::Vector3d& slope = slopes_[k][j];
        const Eigen::Vector3d axis = at.axis(k), moment = radius * axis.cross(slope);
        game.add(k, slope.dot(axis) + moment[0] * kCornerSigns[0] + moment[1] * kCornerSigns[1] +
                        moment[2] * kCornerSigns[2]);
      }
    return solve(game, std::numeric_limits<double>::infinity());
  }

  /// Adds a cut; if there is no room, cuts without weight are dropped first.
  void add(const Cut& cut, const PerCut<double>& weight) {
    for (int k = 0; k < 3; ++k) {
      const auto before = slopes_[k];
      const int count = size_[k];
      slopes_[k][0] = cut.gradient.row(k).transpose();
      size_[k] = 1;
      for (const bool active : {true, false})
        for (int j = 0; j < count && size_[k] < kCapacity; ++j)
          if ((weight[k][j] > 1e-12) == active) slopes_[k][size_[k]++] = before[j];
    }
  }

 private:
  static constexpr int kCapacity = 4;
  std::array<int, 3> size_ = {};
  std::array<std::array<Eigen::Vector3d, kCapacity>, 3> slopes_;
};

}  // namespace

Incumbent descend(Evaluator& evaluator, const Rotation& start, const Cut& cut, int steps, double radius,
                  double enough) {
  Model model(cut);
  Rotation at = start;
  double value = cut.value;
  for (int step = 0; step < steps && !evaluator.exhausted(); ++step) {
    const Strategies best = model.minimum(at, radius);
    const double promised = value - best.value;
    if (!(promised > std::max(1e-14 * value, enough))) break;
    Eigen::Vector3d turn;
    for (int i = 0; i < 3; ++i) turn[i] = radius * (kCornerSigns[i] * best.corner).sum();
    // The axes r become exp(turn) r, in the mesh's coordinates. Going through a quaternion keeps the frame orthonormal.
    const Rotation next = Rotation::from_quaternion((at * rotation_from_vector(turn).inverse()).quaternion());
    const Cut there = evaluator.cut(next);
    model.add(there, best.weight);
    const double length = turn.norm();
    if (there.value < value) {
      if (turn.cwiseAbs().maxCoeff() > 0.99 * radius) radius = std::min(kLargestRadius, 2 * radius);
      else if (value - there.value < 0.25 * promised) radius = std::max(length, 0.5 * radius);
      at = next;
      value = there.value;
    } else {
      radius = std::min(0.5 * radius, std::max(2 * length, 0.1 * radius));
      if (radius < kSmallestRadius) break;
    }
  }
  return {at, value};
}

}  // namespace rectilin::certification

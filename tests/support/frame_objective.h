// The simplest objective of a frame, for tests of optimizers without a mesh: a cube in a given pose.
#pragma once

#include "rectilin/optim/objective.h"

namespace rectilin::test {

/// P/S of a cube whose frame is `pose`: the mean over its three normals of |n|_1 in the new frame. The minimum
/// is 1, at R = D pose only.
class CubeInPose final : public Objective {
 public:
  explicit CubeInPose(const Rotation& pose = Rotation()) : pose_(pose) {}
  std::string name() const override { return "cube in pose"; }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override {
    for (std::size_t i = 0; i < rotations.size(); ++i)
      values[i] = (rotations[i].matrix() * pose_.matrix().transpose()).cwiseAbs().sum() / 3;
  }
  bool has_cuts() const override { return true; }
  void cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) const override {
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const Eigen::Matrix3d products = rotations[i].matrix() * pose_.matrix().transpose();
      cuts[i] = {products.cwiseAbs().sum() / 3, products.cwiseSign() * pose_.matrix() / 3};
    }
  }

  double merit(double value) const override { return 3 / value - 2; }

 private:
  Rotation pose_;
};

}  // namespace rectilin::test

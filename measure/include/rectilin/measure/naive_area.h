// The objective in its simplest form: plain loops, one direction and one face at a time.
#pragma once

#include "rectilin/measure/area_vectors.h"
#include "rectilin/optim/objective.h"

namespace rectilin {

/// sum |u . v_i| in plain C++, compiled with the flags of the project. Compilers must keep the order of the additions,
/// so they do not use vector instructions.
double naive_value(const AreaVectors& vectors, const Vector3& u);

class NaiveArea final : public Objective {
 public:
  /// `vectors` must outlive this object.
  explicit NaiveArea(const AreaVectors& vectors) : vectors_(vectors) {}

  std::string name() const override { return "naive"; }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override;

 private:
  const AreaVectors& vectors_;
};

}  // namespace rectilin

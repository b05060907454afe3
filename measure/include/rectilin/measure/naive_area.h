// The objective as one would write it first: one loop, one direction, one face at a time.
#pragma once

#include "rectilin/measure/area_vectors.h"
#include "rectilin/optim/objective.h"

namespace rectilin {

/// sum |u . v_i| in plain C++, compiled with the project's flags. Its additions must stay in order,
/// so compilers leave it scalar.
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

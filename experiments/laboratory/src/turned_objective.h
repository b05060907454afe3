// An objective of a mesh, as the objective of the mesh turned.
#pragma once

#include <memory>
#include <vector>

#include "rectilin/optim/objective.h"

namespace rectilin::laboratory {

/// value(R) of the mesh turned by Q is value(R Q) of the mesh itself. Gives values alone: no cuts, surrogate or turns.
class TurnedObjective final : public Objective {
 public:
  TurnedObjective(std::shared_ptr<const Objective> objective, const Rotation& turn)
      : objective_(std::move(objective)), turn_(turn) {}

  std::string name() const override { return objective_->name(); }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override {
    std::vector<Rotation> turned;
    turned.reserve(rotations.size());
    for (const Rotation& rotation : rotations) turned.push_back(rotation * turn_);
    objective_->values(turned, values);
  }
  double merit(double value) const override { return objective_->merit(value); }

 private:
  std::shared_ptr<const Objective> objective_;
  Rotation turn_;
};

}  // namespace rectilin::laboratory

#include "rectilin/optim/objective.h"

#include <stdexcept>

namespace rectilin {

double Objective::value(const Rotation& rotation) const {
  double value = 0;
  values({&rotation, 1}, {&value, 1});
  return value;
}

void Objective::cuts(std::span<const Rotation>, std::span<Cut>) const {
  throw std::logic_error(name() + " has no cuts");
}

SmoothValue Objective::smooth(const Rotation&, double) const {
  throw std::logic_error(name() + " has no smooth surrogate");
}

BestTurn Objective::best_turn(const Rotation&, int) const { throw std::logic_error(name() + " has no best turns"); }

}  // namespace rectilin

#include "search/axis_sweep.h"

namespace rectilin {

void AxisSweepOptions::bind(Parameters& table) {
  bind_starts(table, starts,
              "descents, the first from the incumbent, if there is one, the others from random rotations");
  table.real("tolerance", tolerance, 0, 1, "relative decrease of the value that counts as a step down");
}

void AxisSweep::improve(const Rotation& start, Evaluator& evaluator, const Domain&, Random&) const {
  Rotation rotation = start;
  double value = std::numeric_limits<double>::infinity();
  for (int k = 0, idle = 0; idle < 3; k = (k + 1) % 3) {
    const double turned = evaluator.turn(rotation, k);
    if (turned == std::numeric_limits<double>::infinity()) return;
    idle = turned < value * (1 - options_.tolerance) ? 0 : idle + 1;
    value = std::min(value, turned);
  }
}

}  // namespace rectilin

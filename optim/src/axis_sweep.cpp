#include "axis_sweep.h"

namespace rectilin {

void AxisSweepOptions::bind(Parameters& table) {
  table
      .integer("starts", starts, 0, 1000000000,
               "descents: the first from the incumbent, if there is one, the others from random "
               "rotations; "
               "0: until the budget is spent, 10,000 evaluations if it has no limit")
      .real("tolerance", tolerance, 0, 1,
            "relative decrease of the value that counts as a step down");
}

void AxisSweep::run(Evaluator& evaluator, const Chart& chart, Random& random) const {
  improve_from_starts(*this, options_.starts, /*from_incumbent=*/true, evaluator, chart, random);
}

void AxisSweep::improve(const Rotation& start, Evaluator& evaluator, const Chart&, Random&) const {
  if (!evaluator.objective().has_turns())
    throw ParameterError(std::string(kName) + ": '" + evaluator.objective().name() +
                         "' has no best turns");
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

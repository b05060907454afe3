// Exact coordinate descent.
#include "rectilin/optim/registry.h"

namespace rectilin {
namespace {

/// Exact coordinate descent: the frame is turned about its first, second, third, first... axis, each time to the best
/// of all turns (the planar problem of Zunic and Rosin 2003), until three turns in a row do not help. The end need not
/// be a local minimum: turning about two axes at once may still lead downhill.
struct AxisSweepOptions {
  int starts = 0;
  double tolerance = 1e-12;
  void bind(Parameters& table);
};

void AxisSweepOptions::bind(Parameters& table) {
  bind_starts(table, starts,
              "descents: the first from the incumbent, if there is one, the others from random rotations");
  table.real("tolerance", tolerance, 0, 1, "relative decrease of the value that counts as a step down");
}

void axis_sweep(const AxisSweepOptions& options, const Rotation& start, Evaluator& evaluator, const Domain&, Random&) {
  Rotation rotation = start;
  double value = std::numeric_limits<double>::infinity();
  for (int k = 0, idle = 0; idle < 3; k = (k + 1) % 3) {
    const double turned = evaluator.turn(rotation, k);
    if (turned == std::numeric_limits<double>::infinity()) return;
    idle = turned < value * (1 - options.tolerance) ? 0 : idle + 1;
    value = std::min(value, turned);
  }
}

}  // namespace

void add_axis_sweep(Registry& registry) {
  registry.add(LocalMethod<AxisSweepOptions>{
      .name = "axis-sweep",
      .help = "exact coordinate descent: best turns about the frame's axes, one after the other",
      .capabilities = {.uses_domain = false, .needs_turns = true},
      .improve = axis_sweep,
      .starts = &AxisSweepOptions::starts});
}

}  // namespace rectilin

// Fig. 15: pyramids of more and more steps look like the smooth one, but have R = 1, all of them.
#include <algorithm>

#include "figures/experiments.h"
#include "figures/series.h"

namespace rectilin::paper::figures {
namespace {

struct SteppedPyramids {
  int steps = 64;

  void bind(Parameters& parameters) {
    parameters.integer("steps", steps, 1, 100'000, "most steps; the numbers of steps are powers of two");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    Series series{.name = "fig15",
                  .title = "Stepped pyramids and the smooth one",
                  .caption = "However many steps a pyramid has, it is rectilinear; the smooth one is far from it.",
                  .axis = {.label = "steps", .logarithmic = true}};
    for (int n = 1; n <= steps; n *= 2) {
      const std::string count = std::to_string(n);
      series.members.push_back({static_cast<double>(n),
                                sample(n == 1 ? "1 step" : count + " steps", "shape:stepped-pyramid?steps=" + count)});
    }
    series.compared = {sample("smooth", "shape:pyramid")};
    MeasuredSeries measured = measure(series, context);
    const auto least = std::ranges::min_element(measured.members, {}, &Measured::value);
    measured.result.says = "up to " + std::to_string(steps) + " steps R is " + four_digits(least->value()) +
                           " or more (paper: 1), for the smooth pyramid " +
                           number(measured.compared.front().result.value) + " (paper: 0.4270)";
    return measured.result;
  }
};

}  // namespace

Experiment fig15() {
  return make_experiment<SteppedPyramids>("fig15", "Stepped pyramids against the smooth one", "", "steps=8");
}

}  // namespace rectilin::paper::figures

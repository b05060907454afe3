// Fig. 8: a cube with more and more cut off in one direction. All have the same angles between
// faces.
#include <algorithm>

#include "figures/experiments.h"
#include "figures/series.h"

namespace rectilin::paper::figures {
namespace {

struct CutCubes {
  std::array<double, 3> direction{1, -1, 0};
  double deepest = 0.45;
  int steps = 18;

  void bind(Parameters& parameters) {
    parameters.vector3("direction", direction, -1000, 1000, "direction in which parts are cut off")
        .real("deepest", deepest, 0.01, 0.99, "part of the width in that direction that is cut off at most")
        .integer("steps", steps, 1, 1000, "meshes besides the whole cube");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    Series series{.name = "fig8",
                  .title = "Cubes cut in one direction",
                  .caption = "The larger the part cut off, the less rectilinear the rest.",
                  .axis = {.label = "depth of the cut"}};
    const std::string towards = number(direction[0]) + "," + number(direction[1]) + "," + number(direction[2]);
    for (int i = 0; i <= steps; ++i) {
      const double depth = deepest * i / steps;
      series.members.push_back(
          {depth, sample("depth " + number(depth), "shape:cut-cube?direction=" + towards + "&depth=" + number(depth))});
    }
    MeasuredSeries measured = measure(series, context);
    measured.result.says = "R " + course_text(measured.members) + " as more is cut off (paper: well behaved)";
    return measured.result;
  }
};

}  // namespace

Experiment fig8() {
  return make_experiment<CutCubes>("fig8", "Cubes cut in one direction, deeper and deeper", "", "steps=4");
}

}  // namespace rectilin::paper::figures

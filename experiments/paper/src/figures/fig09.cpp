// Fig. 9: a cube with all edges rounded, by larger and larger radii, up to the sphere.
#include <cmath>
#include <numbers>

#include "figures/experiments.h"
#include "figures/series.h"

namespace rectilin::paper::figures {
namespace {

/// R of the ideal shape in its symmetric pose: a cube of side 1 with edges of radius r. Its surface
/// is six squares, twelve quarters of cylinders and a sphere; its shadows along the axes are
/// squares with round corners, and a convex surface covers its shadow twice.
double ideal(double r) {
  using std::numbers::pi;
  const double side = 1 - 2 * r;
  const double surface = 6 * side * side + 6 * pi * r * side + 4 * pi * r * r;
  const double projected = 6 * (1 - (4 - pi) * r * r);
  return 3 * (surface / projected - 2.0 / 3);
}

struct FilletedCubes {
  int steps = 10, segments = 16;

  void bind(Parameters& parameters) {
    parameters.integer("steps", steps, 1, 1000, "radii besides 0; the last one makes a sphere")
        .integer("segments", segments, 1, 512, "divisions of each round edge");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    Series series{.name = "fig9",
                  .title = "Cubes with rounded edges",
                  .caption = "From the cube to the sphere.",
                  .axis = {.label = "radius, in sides of the cube"}};
    double worst = 0;
    for (int i = 0; i <= steps; ++i) {
      const double radius = 0.5 * i / steps;
      series.members.push_back(
          {radius, sample("radius " + number(radius),
                          "shape:filleted-cube?radius=" + number(radius) + "&segments=" + std::to_string(segments))});
    }
    MeasuredSeries measured = measure(series, context);
    for (std::size_t i = 0; i < measured.members.size(); ++i)
      worst = std::max(worst, std::abs(measured.members[i].result.value - ideal(series.members[i].number)));
    measured.result.says = "R " + course_text(measured.members) + " with the radius (paper: well behaved), within " +
                           four_digits(worst) + " of the ideal shapes' R";
    return measured.result;
  }
};

}  // namespace

Experiment fig9() {
  return make_experiment<FilletedCubes>("fig9", "Filleted cubes of growing radius", "", "steps=4&segments=4");
}

}  // namespace rectilin::paper::figures

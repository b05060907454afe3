// Fig. 10: ellipsoids, longer and longer.
#include <numbers>

#include "figures/experiments.h"
#include "figures/series.h"

namespace rectilin::paper::figures {
namespace {

/// R that ever longer ellipsoids tend to: nearly all faces lie along the axis, evenly around it.
/// Then P is two projections, each 2/pi of S.
constexpr double kNeedle = 3 * (std::numbers::pi / 4 - 2.0 / 3);

struct Ellipsoids {
  int longest = 8, steps = 14, faces = 10'000;

  void bind(Parameters& parameters) {
    parameters.integer("longest", longest, 2, 100, "largest ratio of the long axis to the two others")
        .integer("steps", steps, 1, 1000, "meshes besides the sphere")
        .integer("faces", faces, 8, 10'000'000, "triangles of each");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    Series series{.name = "fig10",
                  .title = "Ellipsoids, longer and longer",
                  .caption = "From the sphere towards a needle.",
                  .axis = {.label = "length, in widths"}};
    for (int i = 0; i <= steps; ++i) {
      const double length = 1 + (longest - 1.0) * i / steps;
      series.members.push_back(
          {length, sample("length " + number(length),
                          "shape:ellipsoid?a=" + number(length) + "&b=1&c=1&faces=" + std::to_string(faces))});
    }
    MeasuredSeries measured = measure(series, context);
    measured.result.says = "R " + course_text(measured.members) +
                           " with the length (paper: well behaved); the limit is " + four_digits(kNeedle);
    return measured.result;
  }
};

}  // namespace

Experiment fig10() {
  return make_experiment<Ellipsoids>("fig10", "Ellipsoids, longer and longer", "", "steps=4&faces=500");
}

}  // namespace rectilin::paper::figures

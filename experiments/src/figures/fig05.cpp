// Fig. 5: triangle meshes inscribed into a sphere. S/P tends to 2/3 (eq. 26), R to 0.
#include <cmath>

#include "experiments.h"
#include "series.h"

namespace rectilin::figures {
namespace {

struct Spheres {
  int subdivisions = 6;

  void bind(Parameters& parameters) {
    parameters.integer("subdivisions", subdivisions, 1, 8,
                       "of the octahedron that the finest mesh comes from");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    Series series{.name = "fig5",
                  .title = "Meshes that converge to a sphere",
                  .caption = "An octahedron, subdivided: the more faces, the smaller R.",
                  .axis = {.label = "faces", .logarithmic = true},
                  .logarithmic = true};
    for (int k = 0; k <= subdivisions; ++k) {
      const std::string faces = std::to_string(8 << 2 * k);
      series.members.push_back(
          {static_cast<double>(8 << 2 * k),
           specimen(faces + " faces", "shape:sphere?subdivisions=" + std::to_string(k))});
    }
    MeasuredSeries measured = measure(series, context);
    const double first = measured.members.front().rectilinearity,
                 last = measured.members.back().rectilinearity;
    const double order = std::log(first / last) / std::log(std::pow(4.0, subdivisions));
    char text[160];
    std::snprintf(text, sizeof text,
                  "R falls from %.4f (8 faces) to %.6f (%d faces), as faces^-%.2f; its limit is 0 "
                  "(paper: eq. 26)",
                  first, last, 8 << 2 * subdivisions, order);
    measured.result.says = text;
    return measured.result;
  }
};

}  // namespace

Experiment fig5() {
  return make_experiment<Spheres>("fig5", "Triangle meshes that converge to a sphere", "",
                                  "subdivisions=2");
}

}  // namespace rectilin::figures

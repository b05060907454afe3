// Fig. 5: triangle meshes inscribed into a sphere. S/P tends to 2/3 (eq. 26), R to 0.
#include <cstdio>

#include "figures/experiments.h"
#include "figures/series.h"
#include "rectilin/laboratory/statistics.h"

namespace rectilin::paper::figures {
namespace {

struct Spheres {
  int subdivisions = 6;

  void bind(Parameters& parameters) {
    parameters.integer("subdivisions", subdivisions, 1, 8, "of the octahedron that the finest mesh comes from");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    Series series{.name = "fig5",
                  .title = "Meshes that converge to a sphere",
                  .caption = "An octahedron, subdivided: the more faces, the smaller R.",
                  .axis = {.label = "faces", .logarithmic = true},
                  .logarithmic = true};
    for (int k = 0; k <= subdivisions; ++k) {
      const std::string faces = std::to_string(8 << 2 * k);
      series.members.push_back({static_cast<double>(8 << 2 * k),
                                sample(faces + " faces", "shape:sphere?subdivisions=" + std::to_string(k))});
    }
    MeasuredSeries measured = measure(series, context);
    std::vector<double> faces, values;
    for (std::size_t i = 0; i < series.members.size(); ++i) {
      faces.push_back(series.members[i].number);
      values.push_back(measured.members[i].result.value);
    }
    char text[160];
    std::snprintf(text, sizeof text,
                  "R falls from %.4f (8 faces) to %.6f (%d faces), as faces^%.2f; its limit is 0 "
                  "(paper: eq. 26)",
                  values.front(), values.back(), 8 << 2 * subdivisions, laboratory::power_law_exponent(faces, values));
    measured.result.says = text;
    return measured.result;
  }
};

}  // namespace

Experiment fig5() {
  return make_experiment<Spheres>("fig5", "Triangle meshes that converge to a sphere", "", "subdivisions=2");
}

}  // namespace rectilin::paper::figures

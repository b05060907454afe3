// Fig. 1: a sphere, a cylinder, a rectilinear object and a cube.
#include "figures/experiments.h"
#include "figures/series.h"

namespace rectilin::paper::figures {
namespace {

struct Introduction {
  int subdivisions = 5;

  void bind(Parameters& parameters) {
    parameters.integer("subdivisions", subdivisions, 0, 8, "of the octahedron that the sphere is made of");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<Sample> samples = {sample("sphere", "shape:sphere?subdivisions=" + std::to_string(subdivisions)),
                                   sample("cylinder", "shape:cylinder"), sample("rectilinear object", "shape:stairs"),
                                   sample("cube", "shape:box")};
    for (Sample& s : samples) s.pictured = Up::kZ;
    const std::vector<Measured> results = measure_all(samples, context);
    ExperimentResult result;
    result.says = "R " + course_text(results) + ":";
    for (std::size_t i = 0; i < samples.size(); ++i)
      result.says.append(i > 0 ? ", " : " ").append(samples[i].label + " " + four_digits(results[i].result.value));
    result.says += " (paper: in this order)";
    result.data = to_json(samples, results);
    result.sheets = {sheet("fig1", "From the least rectilinear to the most.", samples, results)};
    result.errors = errors(results);
    return result;
  }
};

}  // namespace

Experiment fig1() {
  return make_experiment<Introduction>("fig1", "Sphere, cylinder, rectilinear object and cube", "", "subdivisions=2");
}

}  // namespace rectilin::paper::figures

// Fig. 1: a sphere, a cylinder, a rectilinear object and a cube.
#include "experiments.h"
#include "series.h"

namespace rectilin::figures {
namespace {

struct Introduction {
  int subdivisions = 5;

  void bind(Parameters& parameters) {
    parameters.integer("subdivisions", subdivisions, 0, 8, "of the octahedron that the sphere is made of");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<Specimen> specimens = {specimen("sphere", "shape:sphere?subdivisions=" + std::to_string(subdivisions)),
                                       specimen("cylinder", "shape:cylinder"),
                                       specimen("rectilinear object", "shape:stairs"), specimen("cube", "shape:box")};
    for (Specimen& s : specimens) s.pictured = Up::kZ;
    const std::vector<Measured> results = measure_all(specimens, context);
    ExperimentResult result;
    result.says = "R " + course(results) + ":";
    for (std::size_t i = 0; i < specimens.size(); ++i)
      result.says.append(i > 0 ? ", " : " ").append(specimens[i].label + " " + four_digits(results[i].rectilinearity));
    result.says += " (paper: in this order)";
    result.data = to_json(specimens, results);
    result.sheets = {sheet("fig1", "From the least rectilinear to the most.", specimens, results)};
    result.errors = errors(specimens, results);
    return result;
  }
};

}  // namespace

Experiment fig1() {
  return make_experiment<Introduction>("fig1", "Sphere, cylinder, rectilinear object and cube", "", "subdivisions=2");
}

}  // namespace rectilin::figures

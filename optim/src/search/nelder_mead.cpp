#include "search/nelder_mead.h"

#include "search/simplex.h"

namespace rectilin {

void NelderMeadOptions::bind(Parameters& table) {
  table.real("size", size, 1e-12, 1.5, "edge of the first simplex, radians")
      .real("tolerance", tolerance, 1e-15, 1, "a smaller simplex has converged, radians")
      .integer("restarts", restarts, 0, 1000000,
               "new simplices, each a tenth as large as the one before, at the point converged to");
}

void NelderMead::improve(const Rotation& start, Evaluator& evaluator, const Domain&, Random& random) const {
  Rotation at = start;
  double size = options_.size;
  for (int round = 0; round <= options_.restarts && !evaluator.exhausted(); ++round, size /= 10) {
    Simplex simplex = Simplex::around(at, size, evaluator, random);
    while (simplex.radius() > options_.tolerance && !evaluator.exhausted()) simplex.step(evaluator);
    at = simplex.best().rotation;
  }
}

}  // namespace rectilin

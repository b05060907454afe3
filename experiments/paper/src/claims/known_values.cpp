#include "claims/known_values.h"

#include <algorithm>
#include <cmath>

#include "rectilin/base/parameters.h"
#include "rectilin/mesh/source.h"
#include "rectilin/paper/closed_forms.h"

namespace rectilin::paper::claims {
namespace {

/// The distance of `expected` from the certified bounds of R, as a margin.
Finding compare(const std::string& source, double expected) {
  const Enclosure best = enclose(load_mesh(source).mesh);
  const double off = std::max({best.least_r() - expected, expected - best.greatest_r(), 0.0});
  return {-off, source, nullptr, best.rotation,
          "R = " + std::to_string(best.least_r()) + ", expected " + std::to_string(expected)};
}

}  // namespace

std::vector<Finding> check_pyramid(Random random) {
  std::vector<Finding> findings;
  for (int i = 0; i < 5; ++i) findings.push_back(compare(posed("pyramid", random), 0.4270));
  return findings;
}

std::vector<Finding> check_stepped_pyramids(Random random) {
  std::vector<Finding> findings;
  for (const int steps : {1, 2, 10, 100, 1000})
    findings.push_back(compare(posed("stepped-pyramid?steps=" + std::to_string(steps), random), 1));
  return findings;
}

std::vector<Finding> check_closed_forms(Random) {
  std::vector<Finding> findings;
  for (const double height : {0.01, 0.1, 0.3, 0.5, 0.7071, 1.0, 2.0, 5.0, 100.0})
    findings.push_back(compare("shape:pyramid?height=" + to_text(height), pyramid_rectilinearity(1, height)));
  for (const int sides : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 17})
    for (const double height : {0.1, 1.0, 10.0}) {
      const std::string source = "shape:prism?sides=" + std::to_string(sides) + "&height=" + to_text(height);
      findings.push_back(compare(source, prism_rectilinearity(sides, 0.5, height)));
    }
  return findings;
}

}  // namespace rectilin::paper::claims

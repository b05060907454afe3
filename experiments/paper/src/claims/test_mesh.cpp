#include "claims/test_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rectilin/measure/measure.h"
#include "rectilin/mesh/source.h"

namespace rectilin::paper::claims {

namespace {

/// Claims do not depend on scale; areas of meshes of 1e200 would exceed double's range. Scaling by
/// a power of two is exact.
void bring_to_scale(Mesh& mesh) {
  double largest = 0;
  for (const Vector3& p : mesh.vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (Vector3& p : mesh.vertices)
    for (double& coordinate : p) coordinate = std::ldexp(coordinate, -exponent);
}

}  // namespace

Enclosure enclose(const ProjectedArea& objective, double gap, int cells) {
  const Rectilinearity result = measure(objective, {.certify = {.gap = gap, .cells = cells}});
  return {result.rotation, result.run.incumbent.value, result.run.value_bound.value()};
}

Enclosure enclose(const Mesh& mesh, double gap) { return enclose(ProjectedArea(area_vectors(mesh)), gap); }

double distance(const Enclosure& a, const Enclosure& b) {
  return std::max({0.0, a.least_r() - b.greatest_r(), b.least_r() - a.greatest_r()});
}

TestMesh make_test_mesh(Mesh mesh, std::string name) {
  bring_to_scale(mesh);
  auto objective = std::make_shared<const ProjectedArea>(area_vectors(mesh), name);
  const Enclosure best = enclose(*objective);
  return {std::move(name), std::make_shared<const Mesh>(std::move(mesh)), std::move(objective), best};
}

TestMesh make_test_mesh(const std::string& source) { return make_test_mesh(load_mesh(source).mesh, source); }

std::string posed(const std::string& shape, Random& random) {
  const char separator = shape.find('?') == std::string::npos ? '?' : '&';
  return "shape:" + shape + separator + "rotate=random&seed=" + std::to_string(random.below(1'000'000));
}

double coordinate_rounding(const Mesh& mesh, double area, bool moved) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &r = mesh.vertices[t[2]];
    const double a = (q - p).norm(), b = (r - p).norm();
    sum += 4 * a * b;
    if (moved) sum += 4 * (a + b) * std::max({p.norm(), q.norm(), r.norm()});
  }
  return kEps * sum / area;
}

double r_change_bound(double eta) {
  return eta < 1 ? 3 * (1 + std::sqrt(3.0)) * eta / (1 - eta) : std::numeric_limits<double>::infinity();
}

}  // namespace rectilin::paper::claims

#include "claims/range_of_r.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rectilin/mesh/source.h"

namespace rectilin::paper::claims {
namespace {

Finding sphere_finding(const std::vector<std::string>& sources) {
  std::vector<double> x, y;
  Finding finding;
  std::string values;
  for (const std::string& source : sources) {
    const ProjectedArea objective(area_vectors(load_mesh(source).mesh));
    const auto faces = static_cast<double>(objective.vectors().faces);
    const Enclosure best = enclose(objective, 0.05 / faces, 200'000);
    x.push_back(std::log(faces));
    y.push_back(std::log(best.greatest_r()));
    finding.where = source;
    finding.rotation = best.rotation;
    values += (values.empty() ? "R = " : ", ") + std::to_string(best.greatest_r());
    finding.margin = std::min(finding.margin, best.least_r());
  }
  // Least squares: the exponent of R as a power of the number of faces.
  const auto n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  const double exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  finding.note = "exponent " + std::to_string(exponent) + "; " + values;
  finding.margin = std::min(finding.margin, 0.0) - std::abs(exponent + 1);
  return finding;
}

}  // namespace

Finding check_positive(const TestMesh& tested) {
  return {tested.best.least_r(), tested.source, nullptr, tested.best.rotation, {}};
}

Finding check_range(const TestMesh& tested) {
  const double r = tested.best.least_r();
  return {std::min(r, 1 - r), tested.source, nullptr, tested.best.rotation, {}};
}

Finding check_similarity(const TestMesh& tested, Random random) {
  const double area = tested.vectors().area();
  const Rotation turn = random_rotation(random);
  const double scale = std::exp(random.uniform(-3, 3)) * (random.chance(0.5) ? 1 : -1);
  const Vector3 shift = std::sqrt(area) * Vector3(random.normal(), random.normal(), random.normal());
  auto moved = std::make_shared<Mesh>(*tested.mesh);
  for (Vector3& p : moved->vertices) p = scale * (turn.matrix() * p + shift);
  const double rounding = r_change_bound(coordinate_rounding(*moved, area * scale * scale, /*moved=*/true));
  const Enclosure after = enclose(*moved);
  return {std::min(rounding - distance(tested.best, after), 0.0),
          tested.source + ", moved",
          std::move(moved),
          after.rotation,
          {}};
}

std::vector<Finding> check_octahedral_spheres(Random) {
  std::vector<std::string> sources;
  for (int level = 2; level <= 5; ++level) sources.push_back("shape:sphere?subdivisions=" + std::to_string(level));
  return {sphere_finding(sources)};
}

std::vector<Finding> check_even_spheres(Random) {
  std::vector<std::string> sources;
  for (const int faces : {100, 400, 1600, 6400})
    sources.push_back("shape:sphere?kind=even&faces=" + std::to_string(faces));
  return {sphere_finding(sources)};
}

std::vector<Vector3> spread_directions(int count) {
  // Turning by the golden angle from one to the next, at equal steps of height: equal areas.
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Vector3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count, r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  return directions;
}

Finding check_mean(const TestMesh& tested) {
  static const std::vector<Vector3> directions = spread_directions(kDirections);
  std::vector<double> h(directions.size());
  FlatSum(tested.vectors()).values(directions, h);
  double mean = 0;
  for (const double value : h) mean += value / (static_cast<double>(h.size()) * tested.vectors().total);
  return {-std::abs(3 * mean - 1.5), tested.source, nullptr, {}, {}};
}

}  // namespace rectilin::paper::claims

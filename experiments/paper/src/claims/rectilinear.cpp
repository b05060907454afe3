#include "claims/rectilinear.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "rectilin/mesh/source.h"
#include "rectilin/paper/closed_forms.h"

namespace rectilin::paper::claims {
namespace {

double slope_at_corner() {
  const double t = std::acos(1 / std::sqrt(3.0));
  return (std::cos(t) + std::sin(t) - 1) / t;
}

/// Angle to the nearest axis; exact for tiny angles.
double tilt(const Vector3& v) {
  const Vector3 a = v.cwiseAbs();
  int k = 0;
  const double longest = a.maxCoeff(&k);
  return std::atan2(std::hypot(a[(k + 1) % 3], a[(k + 2) % 3]), longest);
}

/// Angle between two lines to the nearest of 0 and pi/2.
double angle_defect(const Vector3& a, const Vector3& b) {
  const double along = std::abs(a.dot(b)), across = a.cross(b).norm();
  return std::atan2(std::min(along, across), std::max(along, across));
}

std::vector<Vector3> largest_faces(const AreaVectors& vectors, std::size_t count) {
  std::vector<Vector3> faces;
  for (std::size_t i = 0; i < vectors.size(); ++i) faces.push_back(vectors[i]);
  std::ranges::stable_sort(faces, std::ranges::greater(), [](const Vector3& v) { return v.squaredNorm(); });
  faces.resize(std::min(count, faces.size()));
  return faces;
}

}  // namespace

const double kLeastSlope = slope_at_corner();

double mean_tilt(const AreaVectors& vectors, const Rotation& frame) {
  double sum = 0;
  for (std::size_t i = 0; i < vectors.size(); ++i) sum += vectors[i].norm() * tilt(frame.matrix() * vectors[i]);
  return sum / vectors.total;
}

Rotation frame_by_definition(const AreaVectors& vectors) {
  const Vector3 first = largest_faces(vectors, 1).front().normalized();
  Vector3 across = first.unitOrthogonal();  // if every face is parallel to the first
  double best = 0;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const Vector3 v = vectors[i], part = v - v.dot(first) * first;
    // Of orthogonal faces the largest; one that is only partly so counts for less than its
    // projection.
    const double merit = part.norm() * part.norm() / v.norm();
    if (merit > best) best = merit, across = part;
  }
  Eigen::Matrix3d rows;
  rows.row(2) = first;
  rows.row(0) = across.normalized();
  rows.row(1) = first.cross(across.normalized());
  return Rotation::from_matrix(rows);
}

Finding check_rectilinear_gives_equality(const TestMesh& tested) {
  const Rotation frame = frame_by_definition(tested.vectors());
  const double allowed = 1 + std::sqrt(2.0) * mean_tilt(tested.vectors(), frame);
  return {allowed - tested.best.found, tested.source, nullptr, frame, {}};
}

Finding check_equality_gives_rectilinear(const TestMesh& tested) {
  const double allowed = (tested.best.found - 1) / kLeastSlope;
  const double margin = allowed - mean_tilt(tested.vectors(), tested.best.rotation);
  return {margin, tested.source, nullptr, tested.best.rotation, {}};
}

Finding check_one_iff_rectilinear(const TestMesh& tested) {
  // If R = 1 - d, then P/S - 1 = d / (3 - d), which bounds the mean tilt, and two faces' angle
  // misses 0 or pi/2 by no more than their two tilts.
  const std::vector<Vector3> faces = largest_faces(tested.vectors(), 200);
  double weight = 0, defect = 0;
  for (const Vector3& a : faces) weight += a.norm();
  for (const Vector3& a : faces)
    for (const Vector3& b : faces) defect += angle_defect(a, b) * a.norm() * b.norm() / (weight * weight);
  const double r = tested.best.least_r();
  const double mean = (1 - r) / (2 + r) / kLeastSlope * tested.vectors().total / weight;
  const double only_if = 2 * mean - defect;

  const Rotation frame = frame_by_definition(tested.vectors());
  const double least = rectilinearity(1 + std::sqrt(2.0) * mean_tilt(tested.vectors(), frame));
  return {std::min(only_if, r - least), tested.source, nullptr, tested.best.rotation, {}};
}

std::vector<Finding> check_known_shapes(Random random) {
  std::vector<Finding> findings;
  for (const char* shape : {"box", "box?x=3&y=0.2", "lshape", "stairs", "stepped-pyramid?steps=50"})
    for (int i = 0; i < 5; ++i) {
      const std::string source = posed(shape, random);
      const Enclosure best = enclose(load_mesh(source).mesh);
      findings.push_back({best.least_r() - 1, source, nullptr, best.rotation, {}});
    }
  for (const char* shape :
       {"pyramid", "prism", "cylinder", "cut-cube?depth=0.01", "filleted-cube?radius=0.01", "torus"}) {
    const std::string source = posed(shape, random);
    const Enclosure best = enclose(load_mesh(source).mesh);
    findings.push_back({1 - best.greatest_r(), source, nullptr, best.rotation, {}});
  }
  return findings;
}

std::vector<Finding> check_tilted_top(Random) {
  std::vector<Finding> findings;
  for (const double tilt : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Mesh mesh = tilted_top_cube(tilt);
    const Enclosure best = enclose(mesh, 1e-10);
    const double expected = tilted_top_rectilinearity(tilt);
    // 1 - R = tilt / 2 - tilt^2 / 3 + ..., so the rate is within the tilt of one half.
    const double rate = (1 - best.least_r()) / tilt;
    const double off = std::max(best.least_r() - expected, expected - best.greatest_r());
    Finding finding{std::min(-off, tilt - std::abs(rate - 0.5)),
                    "a cube with its top tilted",
                    std::make_shared<const Mesh>(mesh),
                    best.rotation,
                    {}};
    finding.margin = std::min(finding.margin, 0.0);
    finding.note = "(1 - R) / tilt = " + std::to_string(rate);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace rectilin::paper::claims

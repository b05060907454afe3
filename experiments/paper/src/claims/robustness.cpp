#include "claims/robustness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/source.h"

namespace rectilin::paper::claims {
namespace {

constexpr double kDeleted = 0.9;  // the paper's 90 %
constexpr double kPaperChange = 0.005;
constexpr double kErrors = 8;        // standard errors that no sample will reach, nor the largest over all rotations
constexpr double kFewestKept = 300;  // faces, for the law to be that of large samples

Vector3 area_vector(const Mesh& mesh, const Triangle& t) {
  const Vector3& p = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - p).cross(mesh.vertices[t[2]] - p) / 2;
}

double total_area(const Mesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) area += area_vector(mesh, t).norm();
  return area;
}

/// Sum of the changes of area vectors, face by face, over the area before.
double relative_change(const Mesh& before, const Mesh& after) {
  double change = 0;
  for (std::size_t i = 0; i < before.triangles.size(); ++i)
    change += (area_vector(after, after.triangles[i]) - area_vector(before, before.triangles[i])).norm();
  return change / total_area(before);
}

/// `allowed` less the certified change of R from `tested` to `mesh`.
Finding compare(const TestMesh& tested, Mesh mesh, double allowed, const std::string& what) {
  const Enclosure after = enclose(mesh);
  const double change = distance(tested.best, after);
  return {allowed - change, tested.source + ", " + what, std::make_shared<const Mesh>(std::move(mesh)), after.rotation,
          "R = " + std::to_string(tested.best.least_r()) + " became " + std::to_string(after.least_r())};
}

/// Faces that would be as good a sample if all were of one size.
double effective_faces(const Mesh& mesh) {
  const double area = total_area(mesh);
  double squares = 0;
  for (const Triangle& t : mesh.triangles) squares += (area_vector(mesh, t) / area).squaredNorm();
  return 1 / squares;
}

Finding compare_after_deletion(const TestMesh& tested, Random random, double allowed) {
  return compare(tested, without_faces(*tested.mesh, kDeleted, std::move(random)), allowed,
                 "without 90 % of its faces");
}

}  // namespace

Finding check_stability(const TestMesh& tested, Random random) {
  const Mesh& mesh = *tested.mesh;
  Mesh noisy = with_noise(mesh, 1e-5, random.fork(0));
  const double moved = relative_change(mesh, noisy);
  Finding noise = compare(tested, std::move(noisy), r_change_bound(moved), "with noise");

  Mesh holed = without_faces(mesh, 0.01, random.fork(1));
  const double lost = 1 - total_area(holed) / total_area(mesh);
  if (lost >= 1) return noise;  // of a mesh that is nearly all degenerate nothing may be left
  Finding holes = compare(tested, std::move(holed), r_change_bound(std::max(lost, 0.0)), "with holes");
  return noise.margin < holes.margin ? noise : holes;
}

std::vector<Finding> check_noise_on_fine_box(Random random) {
  const TestMesh box = make_test_mesh("shape:box?faces=20000");
  return {compare(box, with_noise(*box.mesh, 0.002, std::move(random)), 0.1, "with noise of 0.2 % of its extent")};
}

double deletion_error(const TestMesh& tested, double kept) {
  const double ratio = tested.best.found, area = tested.vectors().area();
  double variance = 0;
  for (const Triangle& t : tested.mesh->triangles) {
    const Vector3 v = area_vector(*tested.mesh, t) / area;
    const double deviation = (tested.best.rotation.matrix() * v).lpNorm<1>() - ratio * v.norm();
    variance += deviation * deviation;
  }
  return 3 / (ratio * ratio) * std::sqrt((1 - kept) / kept * variance);
}

std::optional<Finding> check_deletion(const TestMesh& tested, Random random) {
  if (kErrors * deletion_error(tested, 1 - kDeleted) > kPaperChange) return std::nullopt;
  if ((1 - kDeleted) * effective_faces(*tested.mesh) < kFewestKept) return std::nullopt;
  return compare_after_deletion(tested, std::move(random), kPaperChange);
}

std::vector<Finding> check_deletion_on_large_shapes(Random random) {
  std::vector<Finding> findings;
  for (const char* source : {"shape:ellipsoid?faces=1500000", "shape:blob?faces=1500000", "shape:box?faces=20000"})
    if (const auto finding = check_deletion(make_test_mesh(source), random)) findings.push_back(*finding);
  return findings;
}

std::optional<Finding> check_deletion_law(const TestMesh& tested, Random random) {
  if ((1 - kDeleted) * effective_faces(*tested.mesh) < kFewestKept) return std::nullopt;
  // A mesh whose faces all count alike at the best rotation may find a better one.
  const double error = std::max(deletion_error(tested, 1 - kDeleted), 1e-10);
  return compare_after_deletion(tested, std::move(random), kErrors * error);
}

std::vector<Finding> check_deletion_on_small_shape(Random random) {
  const TestMesh torus = make_test_mesh("shape:torus?slices=79&stacks=40");
  std::vector<Finding> findings;
  for (std::uint64_t i = 0; i < 20; ++i)
    findings.push_back(compare_after_deletion(torus, random.fork(i), kPaperChange));
  return findings;
}

std::vector<Finding> check_simplification(Random) {
  std::vector<Finding> findings;
  for (const char* source : {"shape:ellipsoid?faces=20000", "shape:torus?slices=160&stacks=80",
                             "shape:blob?faces=40000", "shape:filleted-cube?segments=30"}) {
    const TestMesh tested = make_test_mesh(source);
    const std::size_t faces = tested.mesh->triangles.size();
    findings.push_back(compare(tested, simplified(*tested.mesh, faces / 10), 0.01, "simplified to a tenth"));
  }
  return findings;
}

}  // namespace rectilin::paper::claims

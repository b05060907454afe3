#include "rectilin/measure/measure.h"

#include <cmath>

namespace rectilin {
namespace {

constexpr double kParallelAngle = 1e-9;
constexpr std::size_t kListed = 10;

/// Whether a face with edges a and b is parallel to axes, whose directions are the rows.
class ParallelTest {
 public:
  ParallelTest(const Eigen::Matrix3d& axes, const Vector3& a, const Vector3& b) : axes_(axes), a_(a), b_(b) {
    const Vector3 normal = a.cross(b);
    heights_ = (axes * normal).cwiseAbs();
    length_ = normal.lpNorm<1>();
    error_ = 1e-14 * a.lpNorm<1>() * b.lpNorm<1>() + 1e-290;  // generous; the second part is for what vanishes
  }

  /// Most faces are far from parallel or, in meshes of right angles, far from not. Only the others need roots.
  bool operator()(int k) const {
    if (heights_[k] > 10 * kParallelAngle * length_ + error_) return false;
    if (heights_[k] + error_ < 0.1 * kParallelAngle * length_) return true;
    const Vector3 normal = a_.normalized().cross(b_.normalized()).normalized();
    return !normal.isZero() && std::abs(axes_.row(k).dot(normal)) <= kParallelAngle;
  }

 private:
  const Eigen::Matrix3d& axes_;
  const Vector3 &a_, &b_;
  Vector3 heights_;        // of the normal along the axes: area times the sine of the angle between axis and face
  double length_, error_;  // the normal's, at most twice the true one; and of a height, at most
};

std::array<ParallelFaces, 3> parallel_faces(const MeshView& mesh, const Rotation& rotation) {
  std::array<ParallelFaces, 3> lists;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vector3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]], b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const ParallelTest parallel(rotation.matrix(), a, b);
    for (int k = 0; k < 3; ++k)
      if (parallel(k) && ++lists[k].count <= kListed) lists[k].first.push_back(i);
  }
  return lists;
}

/// The bounds of R that a run has proved. Values of the objective may be wrong by `error`; the run's lower bound allows
/// for that already.
std::optional<Interval> certified(const RunRecord& run, double error) {
  if (!run.value_bound) return std::nullopt;
  return Interval{rectilinearity(run.incumbent.value + error), rectilinearity(*run.value_bound)};
}

}  // namespace

MeasureOptions measure_options(std::string_view optimizer, const Registry& registry) {
  MeasureOptions options;
  const GlobalMethod<CertifyOptions> certify = certify_method();
  if (optimizer.substr(0, optimizer.find('?')) == certify.name) {
    Parameters table;
    options.certify.bind(table);
    table.set(Spec::parse(optimizer).settings, certify.name);
  } else {
    options.optimizer = registry.make(optimizer);
  }
  return options;
}

Rectilinearity measure(const ProjectedArea& objective, const MeasureOptions& options) {
  Rectilinearity result;
  if (options.optimizer) {
    result.run = run_optimizer(*options.optimizer, objective, options.run);
  } else {
    if (options.certificate) result.certificate.emplace();
    const auto optimizer = make_optimizer(certify_method(), options.certify);
    result.run = run_search(*optimizer, objective, options.run, [&](Evaluator& evaluator, Random&) {
      result.proof = certify(evaluator, options.certify, result.certificate ? &*result.certificate : nullptr);
    });
  }
  if (!result.run.error.empty()) throw MeshError(result.run.error);
  if (!std::isfinite(result.run.merit)) throw MeshError("the budget ends before the first rotation");
  result.value = result.run.merit;
  result.bounds = certified(result.run, 3 * objective.cut_bounds().error);
  result.rotation = result.run.incumbent.rotation;
  result.faces = objective.vectors().faces;
  result.directions = objective.vectors().size();
  result.area = objective.vectors().area();
  return result;
}

Rectilinearity measure(const MeshView& mesh, const MeasureOptions& options) {
  Rectilinearity result = measure(ProjectedArea(area_vectors(mesh)), options);
  result.faces = mesh.triangles.size();
  result.parallel_faces = parallel_faces(mesh, result.rotation);
  return result;
}

}  // namespace rectilin

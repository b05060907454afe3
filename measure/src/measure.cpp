#include "rectilin/measure/measure.h"

#include <cmath>

namespace rectilin {
namespace {

constexpr double kParallelAngle = 1e-9;
constexpr std::size_t kListed = 10;

std::array<ParallelFaces, 3> parallel_faces(const MeshView& mesh, const Rotation& rotation) {
  std::array<ParallelFaces, 3> lists;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vector3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]], b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const Vector3 normal = a.normalized().cross(b.normalized()).normalized();
    if (normal.isZero()) continue;
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(rotation.axis(k).dot(normal)) <= kParallelAngle)) continue;
      if (++lists[k].count <= kListed) lists[k].first.push_back(i);
    }
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

#include "rectilin/retrieval/model.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "rectilin/base/factory.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/optim/certify.h"

namespace rectilin::retrieval {
namespace {

constexpr double kGap = 1e-6;

}  // namespace

Frame surface_frame(const Mesh& mesh) {
  double size = 1e-300;  // coordinates may be too large or too small to be multiplied
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) size = std::max(size, mesh.vertices[v].lpNorm<Eigen::Infinity>());
  const auto corner = [&](std::uint32_t v) -> Vector3 { return mesh.vertices[v] / size; };
  Vector3 sum = Vector3::Zero();
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 a = corner(t[0]), b = corner(t[1]), c = corner(t[2]);
    const double twice = (b - a).cross(c - a).norm();
    sum += twice * (a + b + c) / 3;
    area += twice;
  }
  Frame frame;
  const Vector3 centre = area > 0 ? Vector3(sum / area) : Vector3::Zero();
  double farthest = 0;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) farthest = std::max(farthest, (corner(v) - centre).norm());
  frame.centre = centre * size;
  if (farthest > 0) frame.scale = 1 / farthest / size;
  return frame;
}

Mesh transformed(const Mesh& mesh, const Frame& frame) {
  Mesh result{{}, mesh.triangles};
  result.vertices.reserve(mesh.vertices.size());
  for (const Vector3& v : mesh.vertices)
    result.vertices.push_back(frame.rotation.matrix() * ((v - frame.centre) * frame.scale));
  return result;
}

Model::Model(Mesh mesh) : mesh_(std::move(mesh)), surface_(surface_frame(mesh_)) {}

const Model::Rectilinear& Model::rectilinear() const {
  std::call_once(once_, [&] {
    const ProjectedArea objective(area_vectors(mesh_));
    Evaluator evaluator(objective);
    const CertifyResult result = certify(evaluator, {.gap = kGap});
    rectilinear_ = {result.incumbent.rotation, objective.merit(result.incumbent.value)};
  });
  return rectilinear_;
}

double Model::rectilinearity() const { return rectilinear().value; }

}  // namespace rectilin::retrieval

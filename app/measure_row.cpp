#include "measure_row.h"

#include <cmath>

#include "rectilin/base/batch.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/source.h"

namespace rectilin::app {
namespace {

/// Certify, keeping what a run record has no place for.
class CertifyInDetail final : public Optimizer {
 public:
  CertifyInDetail(const Certify& certify, bool prove) : certify_(certify), prove_(prove) {}

  std::string name() const override { return certify_.name(); }
  Json parameters() const override { return certify_.parameters(); }
  Capabilities capabilities() const override { return certify_.capabilities(); }
  void run(Evaluator& evaluator, const Domain&, Random&) const override {
    result = certify(evaluator, certify_.options(), prove_ ? &certificate : nullptr);
  }

  mutable std::optional<CertifyResult> result;
  mutable Certificate certificate;

 private:
  const Certify& certify_;
  bool prove_;
};

/// For each axis the triangles parallel to it: how many, and the first few.
Json parallel_faces(const Mesh& mesh, const Rotation& rotation) {
  constexpr std::size_t kShown = 10;
  Json lists = Json::array();
  for (int k = 0; k < 3; ++k) {
    std::size_t count = 0;
    Json faces = Json::array();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const Vector3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]], b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
      const Vector3 normal = a.normalized().cross(b.normalized()).normalized();
      if (normal.isZero() || !(std::abs(rotation.axis(k).dot(normal)) <= 1e-9)) continue;
      if (++count <= kShown) faces.push_back(i);
    }
    lists.push_back({{"count", count}, {"faces", faces}});
  }
  return lists;
}

}  // namespace

Row measure_source(const std::string& source, const Optimizer& optimizer, const RunSettings& settings, bool prove) {
  Row row;
  row.name = source;
  try {
    const LoadedMesh loaded = load_mesh(source);
    const ProjectedArea objective(area_vectors(loaded.mesh), source);
    row.report = loaded.report;
    row.faces = loaded.mesh.triangles.size();
    row.directions = objective.vectors().size();
    row.area = objective.vectors().area();
    row.value_error = 3 * objective.cut_bounds().error;
    if (const auto* certify = dynamic_cast<const Certify*>(&optimizer)) {
      const CertifyInDetail detailed(*certify, prove);
      row.run = run_optimizer(detailed, objective, settings);
      row.certified = detailed.result;
      if (row.certified) row.parallel_faces = parallel_faces(loaded.mesh, row.run.incumbent.rotation);
      if (prove && row.run.error.empty() && std::isfinite(row.run.merit))
        row.proof = to_text(rectilin::to_json(detailed.certificate, mesh_digest(loaded.mesh))) + '\n';
    } else {
      row.run = run_optimizer(optimizer, objective, settings);
    }
    row.error = row.run.error;
    if (row.error.empty() && !std::isfinite(row.run.merit)) row.error = "the budget ends before the first rotation";
  } catch (const std::exception& e) {
    row.error = error_about(source, e.what());
  }
  return row;
}

}  // namespace rectilin::app

// The main job: from a mesh to R(M), its proof and its pose.
//
// The rectilinearity of a mesh M of surface area S is (paper, eq. 27)
//
//     R(M) = 3 (max S/P(rotation) - 2/3),
//
// where P is the sum of the areas projected on the three planes of a rotated frame and the maximum runs over all
// rotations. R is 1 exactly for meshes whose faces all meet at right angles, and always above 0.
//
//     const LoadedMesh chair = load_mesh("chair.off");
//     const Rectilinearity r = measure(chair.mesh);
//     std::printf("R = %.6f, between %.6f and %.6f\n", r.value, r.bounds->lower, r.bounds->upper);
//     const Vector3 up = r.rotation.axis(2);     // an axis of the natural pose, in the mesh's coordinates
//
// measure() is the only way from a mesh to these numbers: the command, the experiments and the Python bindings all
// call it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/mesh_view.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/registry.h"
#include "rectilin/optim/run_record.h"

namespace rectilin {

/// Bounds lower <= R(M) <= upper that hold in spite of all rounding.
struct Interval {
  double lower = 0, upper = 0;

  double width() const { return upper - lower; }
};

/// The triangles that are parallel to an axis of the pose: their normals are within 1e-9 radians of a right angle
/// to it.
struct ParallelFaces {
  std::size_t count = 0;
  std::vector<std::size_t> first;  ///< the first ten, as indices into Mesh::triangles
};

struct MeasureOptions {
  CertifyOptions certify = {};  ///< settings of the proof; not used if `optimizer` is set
  bool certificate = false;     ///< write a certificate for verify_certificate(); not used if `optimizer` is set
  /// If set, this searches instead of certify(). R is then bounded only if the optimizer proves bounds
  /// (see Capabilities::certifies).
  std::shared_ptr<const Optimizer> optimizer = {};
  RunSettings run = {};  ///< budget, seed, domain, stop
};

/// The options that stand for an optimizer given as text, such as `ga?population=100` or `certify?gap=1e-9`. Throws
/// ParameterError if the registry has no such optimizer or the optimizer does not accept a setting.
MeasureOptions measure_options(std::string_view optimizer, const Registry& registry = builtin_optimizers());

/// The rectilinearity of a mesh, with its proof, its pose and the record of the search.
struct Rectilinearity {
  double value = 0;                ///< R at `rotation`, the best found; NaN if no rotation was evaluated
  std::optional<Interval> bounds;  ///< proved bounds of R(M); empty if the search proves none
  Rotation rotation;           ///< turns the mesh to its pose; its rows are the pose's axes in the mesh's coordinates
  std::size_t faces = 0;       ///< triangles of the mesh, including those without area
  std::size_t directions = 0;  ///< distinct directions of the triangles' normals, up to sign
  double area = 0;             ///< S in the square of the mesh's unit; infinite or 0 if out of double's range
  std::array<ParallelFaces, 3> parallel_faces;  ///< for each axis of the pose
  std::optional<CertifyResult> proof;           ///< details of certify(): optima, boxes, how the bounds closed
  std::optional<Certificate> certificate;       ///< the proof in a form that can be checked, if it was asked for
  RunRecord run;                                ///< the search: outcome, costs, times, digest, trace
};

/// Measures a mesh. Throws MeshError for a mesh without area, ParameterError if the optimizer cannot work on the
/// objective, and MeshError as well if the search fails or the budget is too small for one evaluation. Thread safe; the
/// results, except times, have the same bits for any number of threads.
Rectilinearity measure(const MeshView& mesh, const MeasureOptions& options = {});

/// The same for a mesh of which only the area vectors are known, or for a point cloud with normals (see
/// area_vectors_of_normals(); the pose is then its certified Manhattan frame). Here `faces` counts only those of
/// positive area, and no parallel faces are listed.
Rectilinearity measure(const ProjectedArea& objective, const MeasureOptions& options = {});

/// A JSON object without nesting: `faces`, `directions`, `area`, `rectilinearity`, `lower` and `upper` (null if nothing
/// is proved), `rotation` (three rows), the search and its costs (see to_json(RunRecord)), `cells` (boxes of the
/// proof), `parallel_faces`, and `optima` if they were asked for.
Json to_json(const Rectilinearity& result);

}  // namespace rectilin

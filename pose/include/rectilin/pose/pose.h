// A pose: how a mesh is moved, scaled and turned before it is looked at or compared.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/base/factory.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// A frame that was considered, and what was measured on it. Areas are in units of the surface's area, so that they do
/// not depend on the mesh's scale.
struct PoseCandidate {
  std::string name;                    ///< where it comes from, e.g. "rectilinear" or "mirror 2, turned by hull"
  Rotation rotation;                   ///< rows: the frame's axes in the mesh's coordinates
  double projected = 0;                ///< P/S: the faces' projections on the three planes, overlaps counted
  std::optional<double> silhouette;    ///< the three silhouettes, overlaps counted once; if the method asks for them
  std::optional<double> volume;        ///< of the box with these axes round the mesh, in units of (surface area)^1.5
  std::vector<double> mirror_defects;  ///< of the planes across the axes, 0: a plane of symmetry ... 1; or none
  std::optional<double> flat_share;    ///< of the hull's outline along an axis, largest: a flat side, if asked for
  double score = 0;                    ///< what the method minimises
};

/// How many other frames are as good, in the method's own sense. Frames that differ by one of the 24 rotations of the
/// cube (frame_symmetries()) are always one.
enum class Uniqueness {
  kUnique,
  kSeveral,    ///< finitely many: Pose::alternatives
  kContinuum,  ///< the frames may turn about one axis: a body of revolution
  kNone,       ///< any frame at all: a sphere
};

std::string to_string(Uniqueness uniqueness);  ///< "unique", "several", "continuum", "none"

/// What a method found. The posed mesh is scale * rotation * (p - centre) for points p.
struct Pose {
  std::string method;  ///< as it can be asked for again
  std::string chosen;  ///< name of the candidate that was taken
  std::string reason;  ///< why it, in one line

  Rotation rotation;
  Vector3 centre = Vector3::Zero();  ///< centre of mass of the surface, in the mesh's coordinates
  double scale = 1;                  ///< one over the largest distance of the mesh's corners from the centre

  Uniqueness uniqueness = Uniqueness::kUnique;
  int free_axis = -1;                  ///< for a continuum: the axis (0, 1, 2) that the frame may turn about
  std::vector<Rotation> alternatives;  ///< other frames as good, if there are finitely many

  /// From 0 to 1: how clearly the choice beats the next frame that differs by more than 10 degrees, on the method's own
  /// scale (papers/pose.md says what it is worth). 1 for methods that do not choose.
  double confidence = 1;

  std::vector<PoseCandidate> candidates;  ///< best first, the chosen one among them
};

/// The mesh in its pose: the surface's centre of mass at the origin, the largest polar distance 1. Throws MeshError if
/// a vertex that no triangle uses lies so far out that the result is beyond the range of numbers.
Mesh normalized(const Mesh& mesh, const Pose& pose);

/// Finds the pose of a mesh. Immutable and thread safe; the same bits for any number of threads. Throws MeshError if
/// the mesh has no area, or is too small for its scale to be a number.
using PoseMethod = std::function<Pose(const Mesh&)>;

/// Every method there is: pca, vertex-pca, normal-pca, rectilinear, hull, box, symmetry, silhouette, cpn, composite.
///
///     const PoseMethod method = pose_methods().make("composite");
///     const Mesh upright = normalized(mesh, method(mesh));
const Factory<PoseMethod>& pose_methods();

}  // namespace rectilin::pose

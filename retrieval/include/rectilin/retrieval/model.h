// A mesh as the descriptors see it: with its poses, which are costly and which several of them share.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::retrieval {

/// From a mesh's coordinates to a canonical frame: x becomes rotation * (x - centre) * scale.
struct Frame {
  Rotation rotation;
  Vector3 centre = Vector3::Zero();  ///< the surface's centre of mass
  double scale = 1;                  ///< the farthest vertex of a triangle gets distance 1 from the centre
};

/// Surface centre of mass and scale as above, rotation the identity. A mesh whose triangles are all one point has
/// scale 1. Right for coordinates of any size.
Frame surface_frame(const Mesh& mesh);

/// The mesh in the canonical frame.
Mesh transformed(const Mesh& mesh, const Frame& frame);

/// A mesh and what is derived from it on demand. Const members are thread safe, and what they return lives as long as
/// the model.
class Model {
 public:
  explicit Model(Mesh mesh);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Mesh& mesh() const { return mesh_; }

  /// The frame that a method of pose normalization finds: see pose_names(). Throws ParameterError for another name.
  const Frame& frame(const std::string& pose) const;

  /// The mesh in that frame.
  const Mesh& posed(const std::string& pose) const;

  /// R(M), certified to 1e-6.
  double rectilinearity() const;

 private:
  struct Rectilinear {
    Rotation rotation;
    double value;
  };
  const Rectilinear& rectilinear() const;

  Mesh mesh_;
  Frame surface_;
  mutable std::once_flag once_;
  mutable Rectilinear rectilinear_{};
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::unique_ptr<Frame>> frames_;
  mutable std::map<std::string, std::unique_ptr<Mesh>> posed_;
};

}  // namespace rectilin::retrieval

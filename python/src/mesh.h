// The house mesh in Python: rectilin.Mesh, load(), save(), shape().
#pragma once

#include <string>
#include <vector>

#include "arrays.h"
#include "rectilin/mesh/mesh_io.h"

namespace rectilin::python {

/// rectilin.Mesh: a mesh in C++ memory, which nobody changes.
struct OwnMesh {
  LoadedMesh loaded;
  std::string name;
};

/// A mesh as a caller gives it, for the length of a call: an OwnMesh, arrays V and F, an object that has both (of
/// trimesh, meshio, Open3D), or a source for load_mesh().
class GivenMesh {
 public:
  /// Throws TypeError or ValueError, MeshError or ParameterError for a source.
  GivenMesh(py::handle vertices, py::handle faces);

  MeshView view() const {
    return {vertices_, own_ ? std::span<const Triangle>(own_->loaded.mesh.triangles) : triangles_};
  }
  Mesh copy() const;
  /// The source's or the OwnMesh's; empty for arrays.
  const std::string& name() const { return name_; }

 private:
  void look_at(const OwnMesh& mesh);
  void take(py::handle vertices, py::handle faces);

  py::object keep_;  // what vertices_ points into
  std::shared_ptr<const OwnMesh> loaded_;
  const OwnMesh* own_ = nullptr;
  std::span<const Vector3> vertices_;
  std::vector<Triangle> triangles_;
  std::string name_;
};

/// A str or what os.fspath() makes one.
bool is_source(py::handle given);
/// Its bytes, which need not be UTF-8. Throws TypeError, ValueError for a null character.
std::string source_of(py::handle given);
/// One, or all that something iterable holds.
std::vector<std::string> sources_of(py::handle given);

void bind_mesh(py::module_& m);

}  // namespace rectilin::python

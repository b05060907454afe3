#include "pose.h"

#include <pybind11/stl.h>

#include "mesh.h"
#include "rectilin/measure/area_vectors.h"
#include "rectilin/pose/axes.h"
#include "rectilin/pose/json.h"
#include "rectilin/pose/pose.h"
#include "tables.h"
#include "threads.h"

namespace rectilin::python {
namespace {

/// rectilin.Pose.
struct FoundPose {
  pose::Pose pose;
  double area = 0;  ///< of the mesh, for to_json()
};

FoundPose find_pose(py::handle vertices, py::handle faces, const std::string& method, py::object threads) {
  const pose::PoseMethod find = pose::pose_methods().make(method);
  const GivenMesh given(vertices, faces);
  const Mesh mesh = given.copy();
  const auto limit = limit_threads(threads);
  const py::gil_scoped_release release;
  return {find(mesh), area_vectors(mesh).area()};
}

std::shared_ptr<OwnMesh> normalized_mesh(const FoundPose& found, py::handle vertices, py::handle faces) {
  const GivenMesh given(vertices, faces);
  auto mesh = std::make_shared<OwnMesh>();
  mesh->name = given.name();
  mesh->loaded.mesh = pose::normalized(given.copy(), found.pose);
  mesh->loaded.report.vertices = mesh->loaded.mesh.vertices.size();
  mesh->loaded.report.polygons = mesh->loaded.mesh.triangles.size();
  return mesh;
}

py::tuple axes_of(py::handle vertices, py::handle faces, py::handle rotation, const std::string& rule) {
  using pose::AxisRule;
  const std::pair<const char*, AxisRule> rules[] = {
      {"free", AxisRule::kFree}, {"ordered", AxisRule::kOrdered}, {"definite", AxisRule::kDefinite}};
  for (const auto& [name, value] : rules) {
    if (rule != name) continue;
    const pose::Axes axes =
        pose::resolve_axes(GivenMesh(vertices, faces).copy(), rotation_of(rotation, std::nullopt, nullptr), value);
    return py::make_tuple(to_array(axes.rotation.matrix()), axes.resolved);
  }
  throw ParameterError("no rule of axes '" + rule + "'; there are free, ordered, definite");
}

}  // namespace

void bind_pose(py::module_& m) {
  py::class_<FoundPose>(m, "Pose", "How a mesh is moved, scaled and turned: what pose() gives. The posed mesh is "
                                   "scale * (V - centre) @ rotation.T.")
      .def_property_readonly("method", [](const FoundPose& p) { return p.pose.method; })
      .def_property_readonly(
          "chosen", [](const FoundPose& p) { return p.pose.chosen; }, "Name of the candidate that was taken.")
      .def_property_readonly(
          "reason", [](const FoundPose& p) { return p.pose.reason; }, "Why it, in one line.")
      .def_property_readonly(
          "rotation", [](const FoundPose& p) { return to_array(p.pose.rotation.matrix()); },
          "(3, 3): its rows are the pose's axes in the mesh's coordinates.")
      .def_property_readonly(
          "centre", [](const FoundPose& p) { return to_array(p.pose.centre); },
          "(3,): the surface's centre of mass.")
      .def_property_readonly(
          "scale", [](const FoundPose& p) { return p.pose.scale; }, "One over the farthest corner's distance from it.")
      .def_property_readonly(
          "uniqueness", [](const FoundPose& p) { return to_string(p.pose.uniqueness); },
          "'unique', 'several', 'continuum' (turns about free_axis) or 'none'.")
      .def_property_readonly(
          "free_axis", [](const FoundPose& p) { return p.pose.free_axis < 0 ? py::object(py::none())
                                                                            : py::int_(p.pose.free_axis); },
          "0, 1 or 2 for a continuum, else None.")
      .def_property_readonly(
          "alternatives",
          [](const FoundPose& p) {
            const auto& list = p.pose.alternatives;
            return to_array(list.size(), false,
                            [&](std::size_t i) -> const Eigen::Matrix3d& { return list[i].matrix(); });
          },
          "(n, 3, 3): other frames as good.")
      .def_property_readonly(
          "confidence", [](const FoundPose& p) { return p.pose.confidence; },
          "From 0 to 1: how clearly the choice beats the next.")
      .def(
          "to_dict", [](const FoundPose& p) { return to_python(to_json(p.pose, p.area)); },
          "All of it, the candidates too, as the command's JSON.")
      .def("normalized", &normalized_mesh, py::arg("V"), py::arg("F") = py::none(),
           "The mesh in this pose: centre of mass at the origin, largest distance from it 1. A Mesh.")
      .def("__repr__", [](const FoundPose& p) {
        return "<rectilin.Pose by " + p.pose.method + ": " + p.pose.chosen + ">";
      });
  m.def("pose", &find_pose, py::arg("V"), py::arg("F") = py::none(), py::kw_only(), py::arg("method") = "composite",
        py::arg("threads") = py::none(), R"(Finds the pose of a mesh.

V, F: see measure(). method: a text such as 'rectilinear' or 'pca', see poses(). Returns a Pose. Raises MeshError for a
mesh without area, ParameterError for an unknown method.

    >>> p = rectilin.pose('shape:stairs?rotate=random', method='rectilinear')
    >>> float(np.abs(p.normalized('shape:stairs?rotate=random').vertices).max()) <= 1
    True)");
  m.def(
      "poses", [] { return list_entries(pose::pose_methods().entries()); },
      R"(The methods of pose(): a list of dicts with name, help and parameters.

    >>> 'composite' in [p['name'] for p in rectilin.poses()]
    True)");
  m.def("resolve_axes", &axes_of, py::arg("V"), py::arg("F") = py::none(), py::kw_only(), py::arg("rotation"),
        py::arg("rule") = "definite",
        R"(Of the 24 rotations with a frame's axes, the one whose order and directions follow from the mesh.

rotation: the frame. rule: 'free' (nearest to the given axes), 'ordered' (second moments fall from x to z) or 'definite'
(directions, too). Returns (rotation, resolved); not resolved if the mesh looks alike either way.

    >>> rotation, resolved = rectilin.resolve_axes('shape:lshape', rotation=np.eye(3))
    >>> rotation.shape
    (3, 3))");
}

}  // namespace rectilin::python

#include "mesh.h"

#include <pybind11/stl.h>

#include "rectilin/base/printable.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"
#include "tables.h"

namespace rectilin::python {
namespace {

/// The first attribute of these names; none if there is no such.
py::object attribute(py::handle object, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (py::hasattr(object, name)) return object.attr(name);
  return py::none();
}

/// Faces of trimesh (`faces`), of Open3D (`triangles`) or of meshio (`cells_dict`).
py::object faces_of(py::handle mesh) {
  py::object faces = attribute(mesh, {"faces", "triangles"});
  if (!faces.is_none() || !py::hasattr(mesh, "cells_dict")) return faces;
  const py::dict cells = mesh.attr("cells_dict");
  for (const auto& [kind, rows] : cells) {
    const std::string name = py::str(kind);
    if (name == "triangle") faces = py::reinterpret_borrow<py::object>(rows);
    else if (name != "vertex" && name != "line")
      throw py::value_error("the mesh has cells of the kind '" + name + "'; only triangles are measured");
  }
  return faces;
}

/// A read-only array that lies in the mesh and keeps it alive.
template <class Number>
py::array_t<Number> inside(const Number* data, std::size_t rows, py::handle owner) {
  py::array_t<Number> array({static_cast<py::ssize_t>(rows), py::ssize_t{3}}, data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// Warns if the mesh is not all that its file holds, in the command's words.
std::shared_ptr<OwnMesh> load(const std::string& source) {
  auto mesh = [&] {
    const py::gil_scoped_release release;
    return std::make_shared<OwnMesh>(OwnMesh{load_mesh(source), source});
  }();
  const std::string loss = summary(mesh->loaded.report);
  if (loss.empty()) return mesh;
  const std::string line = printable(source + ": " + loss);
  if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) throw py::error_already_set();
  return mesh;
}

std::shared_ptr<OwnMesh> copy_of(py::handle vertices, py::handle faces, std::string name) {
  auto mesh = std::make_shared<OwnMesh>();
  mesh->loaded.mesh = GivenMesh(vertices, faces).copy();
  mesh->loaded.report.vertices = mesh->loaded.mesh.vertices.size();
  mesh->loaded.report.polygons = mesh->loaded.mesh.triangles.size();
  mesh->name = std::move(name);
  return mesh;
}

void save(py::handle file, py::handle vertices, py::handle faces, bool binary) {
  const std::shared_ptr<OwnMesh> mesh = copy_of(vertices, faces, "");
  const std::string path = source_of(file);
  std::string failure;
  {
    const py::gil_scoped_release release;
    try {
      write_mesh(path, mesh->loaded.mesh, {.binary = binary});
    } catch (const MeshError&) {
      throw;
    } catch (const std::runtime_error& e) {
      failure = e.what();
    }
  }
  if (failure.empty()) return;
  PyErr_SetString(PyExc_OSError, printable(failure).c_str());
  throw py::error_already_set();
}

}  // namespace

bool is_source(py::handle given) { return py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"); }

std::string source_of(py::handle given) {
  if (!is_source(given))
    throw py::type_error("a name of a file is wanted, not " + std::string(py::str(py::type::of(given))));
  std::string name = py::module_::import("os").attr("fsencode")(given).cast<py::bytes>();
  if (name.find('\0') != std::string::npos) throw py::value_error("a name of a file with a null character");
  return name;
}

std::vector<std::string> sources_of(py::handle given) {
  if (is_source(given)) return {source_of(given)};
  if (!py::isinstance<py::iterable>(given))
    throw py::type_error("names of files are wanted, not " + std::string(py::str(py::type::of(given))));
  std::vector<std::string> sources;
  for (const py::handle source : given) sources.push_back(source_of(source));
  return sources;
}

GivenMesh::GivenMesh(py::handle vertices, py::handle faces) {
  if (!faces.is_none()) {
    take(vertices, faces);
  } else if (py::isinstance<OwnMesh>(vertices)) {
    keep_ = py::reinterpret_borrow<py::object>(vertices);
    look_at(vertices.cast<const OwnMesh&>());
  } else if (is_source(vertices)) {
    loaded_ = load(source_of(vertices));
    look_at(*loaded_);
  } else {
    const py::object points = attribute(vertices, {"vertices", "points"}), triangles = faces_of(vertices);
    if (points.is_none() || triangles.is_none())
      throw py::type_error(
          "a mesh is wanted: V and F, an object with .vertices and .faces, or the name of a file; not " +
          std::string(py::str(py::type::of(vertices))) + " alone");
    take(points, triangles);
  }
}

Mesh GivenMesh::copy() const {
  const MeshView seen = view();
  return {{seen.vertices.begin(), seen.vertices.end()}, {seen.triangles.begin(), seen.triangles.end()}};
}

void GivenMesh::look_at(const OwnMesh& mesh) {
  own_ = &mesh;
  vertices_ = mesh.loaded.mesh.vertices;
  name_ = mesh.name;
}

void GivenMesh::take(py::handle vertices, py::handle faces) {
  const py::array_t<double> rows = real_rows(vertices, "V");
  keep_ = rows;
  vertices_ = vectors_in(rows);
  require_finite(vertices_, "V");
  triangles_ = triangles_of(faces, vertices_.size());
}

void bind_mesh(py::module_& m) {
  py::class_<OwnMesh, std::shared_ptr<OwnMesh>>(m, "Mesh", R"(A triangle mesh that the library owns; nothing changes it.

Mesh(V, F, name='') copies V, (n, 3) coordinates, and F, (m, 3) indices into V. Accepted wherever V and F are, without
a copy and without a check.

    >>> mesh = rectilin.shape('box?x=2')
    >>> mesh.vertices.shape, mesh.faces.shape
    ((8, 3), (12, 3)))")
      .def(py::init(&copy_of), py::arg("V"), py::arg("F") = py::none(), py::arg("name") = "")
      .def_property_readonly(
          "vertices",
          [](py::object self) {
            const auto& vertices = self.cast<const OwnMesh&>().loaded.mesh.vertices;
            return inside(reinterpret_cast<const double*>(vertices.data()), vertices.size(), self);
          },
          "(n, 3) float64, in the mesh's own memory; read-only.")
      .def_property_readonly(
          "faces",
          [](py::object self) {
            const auto& triangles = self.cast<const OwnMesh&>().loaded.mesh.triangles;
            return inside(reinterpret_cast<const std::uint32_t*>(triangles.data()), triangles.size(), self);
          },
          "(m, 3) uint32, in the mesh's own memory; read-only.")
      .def_property_readonly(
          "name", [](const OwnMesh& self) { return name_to_python(self.name); }, "The file or shape as given.")
      .def_property_readonly(
          "report", [](const OwnMesh& self) { return to_python(to_json(self.loaded.report)); },
          "What the reader found and repaired, as counts: see the README's table.")
      .def("__repr__", [](const OwnMesh& self) {
        return "<rectilin.Mesh '" + printable(self.name) + "': " + std::to_string(self.loaded.mesh.vertices.size()) +
               " vertices, " + std::to_string(self.loaded.mesh.triangles.size()) + " faces>";
      });

  m.def(
      "load", [](py::handle source) { return load(source_of(source)); }, py::arg("source"), R"(Loads a mesh.

source: a file (.off .obj .ply .stl), or 'shape:NAME?key=value'. Returns a Mesh. Raises MeshError for a file that cannot
be read, ParameterError for a shape that cannot be made; warns (UserWarning) of what was left out of the mesh, as all
functions do that are given the name of a file. Mesh.report has the counts.

    >>> rectilin.load('shape:pyramid').faces.shape
    (6, 3))");
  m.def(
      "shape", [](const std::string& spec) { return load("shape:" + spec); }, py::arg("spec"),
      R"(Makes a built-in shape: 'sphere?subdivisions=4&rotate=random&seed=7'. Same text, same mesh. See shapes().

    >>> len(rectilin.shape('cylinder?sides=64').faces) > 64
    True)");
  m.def("save", &save, py::arg("file"), py::arg("V"), py::arg("F") = py::none(), py::kw_only(),
        py::arg("binary") = true,
        R"(Writes a mesh in the format of the file's ending (.off .obj .ply .stl).

V, F: see measure(). binary: PLY and STL only. PLY and text keep every bit; binary STL holds single precision. Raises
MeshError if the format cannot hold the mesh, OSError if the file cannot be written.

    >>> rectilin.save('box.ply', rectilin.shape('box')))");
  m.def(
      "shapes", [] { return list_entries(shape_table().entries()); },
      R"(The built-in shapes: a list of dicts with name, help and parameters.

    >>> 'pyramid' in [s['name'] for s in rectilin.shapes()]
    True)");
  m.def(
      "sources",
      [](py::handle given) {
        const std::vector<std::string> names = sources_of(given);
        return names_to_python([&] {
          const py::gil_scoped_release release;
          return expand_folders(names);
        }());
      },
      py::arg("names"), R"(Replaces folders by the mesh files in and below them, sorted.

    >>> rectilin.sources(['shape:box'])
    ['shape:box'])");
}

}  // namespace rectilin::python

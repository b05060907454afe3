// Between numpy and the library: meshes, rotations, numbers, JSON.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/base/parameters.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh_view.h"
#include "rectilin/optim/domain.h"

// In help() whatever is taken as it comes is an object.
#if PYBIND11_VERSION_HEX < 0x020C0000
namespace pybind11::detail {
template <>
struct handle_type_name<handle> {
  static constexpr auto name = const_name("object");
};
}  // namespace pybind11::detail
#endif

namespace rectilin::python {

namespace py = pybind11;

/// Anything that holds (n, 3) real numbers, as C-contiguous doubles: the array itself if it is that. `name` stands for
/// it in errors. Throws TypeError or ValueError.
py::array_t<double> real_rows(py::handle numbers, const std::string& name);

/// Rows of such an array, in place.
std::span<const Vector3> vectors_in(const py::array_t<double>& rows);

/// Throws ValueError that names the first row with a number that is not finite.
void require_finite(std::span<const Vector3> rows, const std::string& name);

/// A copy of the faces: (m, 3) integers, each from 0 to below `vertices`. A copy, since what another thread writes into
/// the array later must not lead beyond the vertices.
std::vector<Triangle> triangles_of(py::handle faces, std::size_t vertices);

/// What rotations are given as.
struct Rotations {
  std::vector<Rotation> items;
  bool one = false;  ///< a single one was given, not a list of them
};

/// `form` is "matrix", "quaternion" (x, y, z, w), "rodrigues", "vector", "angles" or "domain" (a point of the domain's
/// box). Without it (3, 3) and (n, 3, 3) are matrices, (4,) and (n, 4) quaternions, and an object with as_matrix() (of
/// scipy) is what that gives.
Rotations rotations_of(py::handle given, const std::optional<std::string>& form, const Domain* domain);
/// Exactly one.
Rotation rotation_of(py::handle given, const std::optional<std::string>& form, const Domain* domain);

py::array_t<double> to_array(const Eigen::Matrix3d& matrix);
py::array_t<double> to_array(const Vector3& vector);
/// Shape (n, 3, 3), or (3, 3) if only one was asked for.
template <class GetMatrix>
py::array_t<double> to_array(std::size_t count, bool one, const GetMatrix& matrix_at) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(count), 3, 3};
  if (one) shape.erase(shape.begin());
  py::array_t<double> result(shape);
  double* out = result.mutable_data();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Matrix3d& m = matrix_at(i);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) *out++ = m(row, column);
  }
  return result;
}

/// A float if only one was asked for, else an array.
py::object to_python(const std::vector<double>& values, bool one);

py::object to_python(const Json& json);

/// What an object is, for errors: its repr() in one line of moderate length.
std::string said(py::handle object);

/// A name that may be of a file, which need not be UTF-8, as a str.
py::str name_to_python(const std::string& name);
py::list names_to_python(const std::vector<std::string>& names);

/// None, or a whole number from `least`; numpy's integers, too. Throws ParameterError with the name.
std::optional<std::uint64_t> whole_number(py::handle number, const char* name, std::uint64_t least);

}  // namespace rectilin::python

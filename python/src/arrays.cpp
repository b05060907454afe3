#include "arrays.h"

#include <Eigen/LU>
#include <limits>

#include "rectilin/base/printable.h"

namespace rectilin::python {
namespace {

constexpr int kInPlace = py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
using Doubles = py::array_t<double, kInPlace>;

static_assert(sizeof(Vector3) == 3 * sizeof(double) && alignof(Vector3) == alignof(double));

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

py::array any_array(py::handle numbers, const std::string& name) {
  py::array array = py::array::ensure(numbers);
  if (!array) throw py::type_error(name + " is no array but " + std::string(py::str(py::type::of(numbers))));
  return array;
}

Doubles doubles(py::handle numbers, const std::string& name) {
  const py::array array = any_array(numbers, name);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error(name + " holds " + std::string(py::str(array.dtype())) + ", not real numbers");
  Doubles result = Doubles::ensure(array);
  if (!result) throw py::error_already_set();
  return result;
}

void require_rows(const py::array& array, const std::string& name, const char* rows) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error(name + " has shape " + shape_text(array) + ", not (" + rows + ", 3)");
}

template <class Index>
std::vector<Triangle> checked_triangles(const py::array& faces, std::size_t vertices) {
  const auto array = py::array_t<Index, kInPlace>::ensure(faces);
  if (!array) throw py::error_already_set();
  const Index* in = array.data();
  std::vector<Triangle> triangles(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index index = *in++;
      // A negative index becomes a large one.
      if (static_cast<std::uint64_t>(index) >= vertices)
        throw py::value_error("F[" + std::to_string(i) + ", " + std::to_string(k) + "] is " + std::to_string(index) +
                              ", but there are " + std::to_string(vertices) + " vertices");
      triangles[i][k] = static_cast<std::uint32_t>(index);
    }
  return triangles;
}

// The next three make a rotation of numbers; their errors go on from "rotation 7".

Rotation from_matrix(const double* x) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = x[i];
  if (!((m * m.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-8) || !(m.determinant() > 0))
    throw py::value_error(" is no rotation: its rows are not orthonormal and right-handed");
  return Rotation::from_matrix(m);
}

Rotation from_quaternion(const double* x) {
  const Eigen::Quaterniond q(x[3], x[0], x[1], x[2]);
  const double norm = q.norm();
  if (!(norm > 1e-150 && norm < 1e150)) throw py::value_error(" is no rotation: its length is 0 or no number");
  return Rotation::from_quaternion(q);
}

/// Turns three numbers into a rotation.
struct ThreeNumbers {
  enum class Form { kRodrigues, kVector, kAngles, kDomain } form;
  const Domain* domain;

  Rotation operator()(const double* x) const {
    const Eigen::Vector3d v(x[0], x[1], x[2]);
    if (!(v.cwiseAbs().maxCoeff() < 1e100)) throw py::value_error(" is no rotation: a number is not finite");
    switch (form) {
      case Form::kRodrigues:
        return rotation_from_rodrigues(v);
      case Form::kVector:
        return rotation_from_vector(v);
      case Form::kAngles:
        return rotation_from_euler(v[0], v[1], v[2]);
      case Form::kDomain:
        break;
    }
    return domain->rotation(v);
  }
};

/// `array` holds one item of shape `item`, or a list of them.
template <class Make>
Rotations read(const Doubles& array, std::vector<py::ssize_t> item, const Make& make) {
  const py::ssize_t extra = array.ndim() - static_cast<py::ssize_t>(item.size());
  bool fits = extra == 0 || extra == 1;
  py::ssize_t size = 1;
  for (std::size_t k = 0; k < item.size(); ++k) {
    fits = fits && array.shape(static_cast<py::ssize_t>(k) + extra) == item[k];
    size *= item[k];
  }
  if (!fits) {
    const std::string last = item.size() == 2 ? "3, 3)" : std::to_string(item[0]) + ")";
    throw py::value_error("the rotations have shape " + shape_text(array) + ", not (n, " + last + " nor (" +
                          (item.size() == 2 ? "3, 3)" : std::to_string(item[0]) + ",)"));
  }
  Rotations rotations;
  rotations.one = extra == 0;
  const std::size_t count = rotations.one ? 1 : static_cast<std::size_t>(array.shape(0));
  rotations.items.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* x = array.data() + i * static_cast<std::size_t>(size);
    try {
      rotations.items.push_back(make(x));
    } catch (const py::value_error& e) {
      throw py::value_error((rotations.one ? "the rotation" : "rotation " + std::to_string(i)) + e.what());
    }
  }
  return rotations;
}

}  // namespace

py::array_t<double> real_rows(py::handle numbers, const std::string& name) {
  const py::array array = any_array(numbers, name);
  require_rows(array, name, "n");
  return doubles(array, name);
}

std::span<const Vector3> vectors_in(const py::array_t<double>& rows) {
  return {reinterpret_cast<const Vector3*>(rows.data()), static_cast<std::size_t>(rows.shape(0))};
}

void require_finite(std::span<const Vector3> rows, const std::string& name) {
  // x - x is 0 or, where x is not finite, NaN; a sum of many is checked at once.
  Vector3 sum = Vector3::Zero();
  for (const Vector3& v : rows) sum += v - v;
  if (sum.isZero(0)) return;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!rows[i].allFinite()) throw py::value_error(name + "[" + std::to_string(i) + "] is not finite");
}

std::vector<Triangle> triangles_of(py::handle faces, std::size_t vertices) {
  const py::array array = any_array(faces, "F");
  require_rows(array, "F", "m");
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u')
    throw py::type_error("F holds " + std::string(py::str(array.dtype())) + ", not integers");
  if (vertices > std::numeric_limits<std::uint32_t>::max()) throw py::value_error("V has more than 2^32 vertices");
  const bool wide = array.itemsize() > 4;
  if (kind == 'u')
    return wide ? checked_triangles<std::uint64_t>(array, vertices) : checked_triangles<std::uint32_t>(array, vertices);
  return wide ? checked_triangles<std::int64_t>(array, vertices) : checked_triangles<std::int32_t>(array, vertices);
}

Rotations rotations_of(py::handle given, const std::optional<std::string>& form, const Domain* domain) {
  if (!form && py::hasattr(given, "as_matrix")) return rotations_of(given.attr("as_matrix")(), "matrix", domain);
  const Doubles array = doubles(given, "the list of rotations");
  const py::ssize_t last = array.ndim() > 0 ? array.shape(array.ndim() - 1) : 0;
  if (form ? *form == "matrix" : array.ndim() >= 2 && last == 3 && array.shape(array.ndim() - 2) == 3)
    return read(array, {3, 3}, from_matrix);
  if (form ? *form == "quaternion" : last == 4) return read(array, {4}, from_quaternion);
  using Form = ThreeNumbers::Form;
  if (form == "rodrigues") return read(array, {3}, ThreeNumbers{Form::kRodrigues, nullptr});
  if (form == "vector") return read(array, {3}, ThreeNumbers{Form::kVector, nullptr});
  if (form == "angles") return read(array, {3}, ThreeNumbers{Form::kAngles, nullptr});
  if (form == "domain" && domain) return read(array, {3}, ThreeNumbers{Form::kDomain, domain});
  if (!form)
    throw py::value_error(
        "the rotations have shape " + shape_text(array) +
        ": (n, 3, 3) are matrices, (n, 4) quaternions; say form='rodrigues', 'vector' or 'angles' for "
        "(n, 3)");
  throw ParameterError("no form of rotations '" + *form + "'; there are matrix, quaternion, rodrigues, vector, angles" +
                       (domain ? ", domain" : ""));
}

Rotation rotation_of(py::handle given, const std::optional<std::string>& form, const Domain* domain) {
  const Rotations rotations = rotations_of(given, form, domain);
  if (!rotations.one) throw py::value_error("one rotation is wanted, not a list of them");
  return rotations.items.front();
}

py::array_t<double> to_array(const Eigen::Matrix3d& matrix) {
  return to_array(1, true, [&](std::size_t) -> const Eigen::Matrix3d& { return matrix; });
}

py::array_t<double> to_array(const Vector3& vector) { return py::array_t<double>(3, vector.data()); }

py::object to_python(const std::vector<double>& values, bool one) {
  if (one) return py::float_(values.front());
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::object to_python(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      py::dict result;
      for (const auto& [key, value] : json.items()) result[py::str(key)] = to_python(value);
      return result;
    }
    case Json::value_t::array: {
      py::list result;
      for (const Json& value : json) result.append(to_python(value));
      return result;
    }
    case Json::value_t::string:
      return name_to_python(json.get_ref<const std::string&>());
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

std::string said(py::handle object) {
  constexpr std::size_t kLongest = 80;  // columns
  try {
    return shortened(py::repr(object).cast<std::string>(), kLongest);
  } catch (const std::exception&) {  // an object that cannot even say what it is
    return "something of " + std::string(py::str(py::type::of(object)));
  }
}

py::str name_to_python(const std::string& name) {
  PyObject* text = PyUnicode_DecodeFSDefaultAndSize(name.data(), static_cast<py::ssize_t>(name.size()));
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

py::list names_to_python(const std::vector<std::string>& names) {
  py::list list;
  for (const std::string& name : names) list.append(name_to_python(name));
  return list;
}

std::optional<std::uint64_t> whole_number(py::handle number, const char* name, std::uint64_t least) {
  if (number.is_none()) return std::nullopt;
  const auto refuse = [&] {
    throw ParameterError(std::string(name) + " is " + said(number) + ", not a whole number from " +
                         std::to_string(least));
  };
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()));
  if (!index) {
    PyErr_Clear();
    refuse();
  }
  const std::uint64_t value = PyLong_AsUnsignedLongLong(index.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse();
  }
  if (value < least) refuse();
  return value;
}

}  // namespace rectilin::python

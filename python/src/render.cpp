#include "render.h"

#include "mesh.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/render/shaded.h"
#include "rectilin/render/silhouette_area.h"
#include "rectilin/render/view_sphere.h"
#include "threads.h"

namespace rectilin::python {
namespace {

Vector3 direction_of(py::handle given) {
  const auto row = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!row || row.ndim() != 1 || row.shape(0) != 3) throw py::value_error("the direction is not three numbers");
  const Vector3 direction(row.data());
  if (!direction.allFinite() || direction.isZero(0)) throw py::value_error("the direction is zero or not finite");
  return direction;
}

/// Renders with the rows of `rotation` as the picture's right, up and direction to the viewer; seen from `direction`
/// without it.
template <class Number, class Draw>
py::array_t<Number> picture(py::handle vertices, py::handle faces, py::object direction, py::object rotation, int size,
                            const Draw& draw) {
  if (!direction.is_none() && !rotation.is_none())
    throw ParameterError("a direction or a rotation says where the viewer is, not both");
  const Rotation frame = rotation.is_none()
                             ? render::frame_towards(direction.is_none() ? Vector3::UnitZ() : direction_of(direction))
                             : rotation_of(rotation, std::nullopt, nullptr);
  const GivenMesh given(vertices, faces);
  const Mesh mesh = given.copy();
  std::vector<Number> values;
  {
    const py::gil_scoped_release release;
    values = draw(mesh, frame);
  }
  py::array_t<Number> image({py::ssize_t{size}, py::ssize_t{size}});
  std::copy(values.begin(), values.end(), image.mutable_data());
  return image;
}

py::array_t<std::uint16_t> depth_picture(py::handle vertices, py::handle faces, py::object direction,
                                         py::object rotation, int size) {
  return picture<std::uint16_t>(
      vertices, faces, std::move(direction), std::move(rotation), size, [&](const Mesh& mesh, const Rotation& frame) {
        return render::ViewRenderer(mesh, render::ball_around(mesh), {.size = size}).render(frame).depth;
      });
}

py::array_t<std::uint8_t> shaded_picture(py::handle vertices, py::handle faces, py::object direction,
                                         py::object rotation, int size) {
  return picture<std::uint8_t>(vertices, faces, std::move(direction), std::move(rotation), size,
                               [&](const Mesh& mesh, const Rotation& frame) {
                                 return render::shaded(mesh, render::ball_fitting(mesh, frame, 0.05), frame, size);
                               });
}

py::object silhouettes(py::handle vertices, py::handle faces, py::handle directions, double tolerance,
                       py::object threads) {
  const auto any = py::array::ensure(directions);
  const bool one = any && any.ndim() == 1;
  std::vector<Vector3> list;
  if (one) {
    list.push_back(direction_of(directions));
  } else {
    const py::array_t<double> rows = real_rows(directions, "directions");
    for (const Vector3& d : vectors_in(rows)) list.push_back(d);
  }
  const GivenMesh given(vertices, faces);
  const Mesh mesh = given.copy();
  const auto limit = limit_threads(threads);
  std::vector<render::AreaInterval> areas;
  {
    const py::gil_scoped_release release;
    areas = render::Silhouette(mesh).areas(list, tolerance);
  }
  py::array_t<double> lower(static_cast<py::ssize_t>(areas.size())), upper(static_cast<py::ssize_t>(areas.size()));
  for (std::size_t i = 0; i < areas.size(); ++i) {
    lower.mutable_at(static_cast<py::ssize_t>(i)) = areas[i].lower;
    upper.mutable_at(static_cast<py::ssize_t>(i)) = areas[i].upper;
  }
  if (one) return py::make_tuple(areas.front().lower, areas.front().upper);
  return py::make_tuple(lower, upper);
}

}  // namespace

void bind_render(py::module_& m) {
  m.def("render", &depth_picture, py::arg("V"), py::arg("F") = py::none(), py::kw_only(),
        py::arg("direction") = py::none(), py::arg("rotation") = py::none(), py::arg("size") = 256,
        R"(A depth picture of a mesh, in parallel projection.

V, F: see measure(). direction: from the mesh to the viewer, (3,); +z without it. rotation: or the picture's right, up and
direction to the viewer as rows. size: pixels in a row, to 16384. Returns (size, size) uint16, rows from the top: 0 is
background, greater is nearer. The mesh fits into the picture whatever the direction.

    >>> picture = rectilin.render('shape:box', direction=(1, 1, 1), size=64)
    >>> picture.shape, bool((picture > 0).any()), int(picture[0, 0])
    ((64, 64), True, 0))");
  m.def("shaded", &shaded_picture, py::arg("V"), py::arg("F") = py::none(), py::kw_only(),
        py::arg("direction") = py::none(), py::arg("rotation") = py::none(), py::arg("size") = 256,
        R"(A picture of a mesh as people like to see it: (size, size) uint8, grey on white, with creases and outlines.

The arguments are those of render(); the mesh is as large as fits.

    >>> rectilin.shaded('shape:stairs', direction=(1, 0.5, 0.7)).min() < 128
    True)");
  m.def("silhouette_area", &silhouettes, py::arg("V"), py::arg("F") = py::none(), py::kw_only(),
        py::arg("directions") = py::make_tuple(0, 0, 1), py::arg("tolerance") = 1e-6, py::arg("threads") = py::none(),
        R"(The area of a mesh's shadow along directions, enclosed with certainty.

V, F: see measure(). directions: (3,) or (n, 3), of any length. tolerance: the interval's width over its upper end.
Returns (lower, upper), floats or (n,) arrays, in the square of the mesh's unit: the exact area lies in between, rounding
allowed for. Raises ValueError for a direction that is zero or not finite.

    >>> lower, upper = rectilin.silhouette_area('shape:box', directions=(0, 0, 5))
    >>> lower <= 1 <= upper
    True)");
  m.def(
      "views",
      [](std::size_t directions) {
        const render::ViewSphere sphere = render::ViewSphere::of_size(directions);
        return py::array_t<double>({static_cast<py::ssize_t>(sphere.size()), py::ssize_t{3}},
                                   reinterpret_cast<const double*>(sphere.directions().data()));
      },
      py::arg("count"),
      R"(The unit vectors of the paper's geodesic sphere of 6, 18, 66, 258, 1026 ... directions: (count, 3).

    >>> rectilin.views(18).shape
    (18, 3))");
}

}  // namespace rectilin::python

#include "retrieval.h"

#include "mesh.h"
#include "rectilin/retrieval/descriptor.h"
#include "tables.h"

namespace rectilin::python {
namespace {

using Bytes = py::array_t<std::uint8_t>;

Bytes describe(py::handle vertices, py::handle faces, const std::string& descriptor) {
  const retrieval::DescriptorPointer made = retrieval::make_descriptor(descriptor);
  const GivenMesh given(vertices, faces);
  retrieval::Signature signature;
  Mesh mesh = given.copy();
  {
    const py::gil_scoped_release release;
    signature = made->describe(retrieval::Model(std::move(mesh)));
  }
  return Bytes(static_cast<py::ssize_t>(signature.size()), signature.data());
}

/// Bytes of the length that the descriptor's signatures have.
retrieval::SignatureView signature_in(const py::array& array, std::size_t bytes, const char* name) {
  if (!py::isinstance<Bytes>(array) || array.ndim() != 1 || static_cast<std::size_t>(array.shape(0)) != bytes ||
      array.strides(0) != 1)
    throw py::value_error(std::string(name) + " is no signature of this descriptor: " + std::to_string(bytes) +
                          " bytes (uint8) in a row");
  return {static_cast<const std::uint8_t*>(array.data()), bytes};
}

double distance(const py::array& a, const py::array& b, const std::string& descriptor) {
  const retrieval::DescriptorPointer made = retrieval::make_descriptor(descriptor);
  return made->distance(signature_in(a, made->bytes(), "a"), signature_in(b, made->bytes(), "b"));
}

}  // namespace

void bind_retrieval(py::module_& m) {
  m.def("describe", &describe, py::arg("V"), py::arg("F") = py::none(), py::kw_only(), py::arg("descriptor") = "gsmd",
        R"(A mesh's signature by a shape descriptor: (bytes,) uint8, for distance().

V, F: see measure(). descriptor: a text such as 'gsmd?views=66' or 'gsmd+0.3*shd', see descriptors(). Raises MeshError for
a mesh that has none, ParameterError for an unknown descriptor.

    >>> box = rectilin.describe('shape:box?rotate=random')
    >>> rectilin.distance(box, box)
    0.0)");
  m.def("distance", &distance, py::arg("a"), py::arg("b"), py::kw_only(), py::arg("descriptor") = "gsmd",
        R"(How different two signatures of one descriptor are: 0 for equal ones, about 1 for unlike ones.

Raises ValueError if one of them is no signature of it.

    >>> box, ball = (rectilin.describe('shape:' + name) for name in ['box', 'sphere'])
    >>> rectilin.distance(box, ball) > 0
    True)");
  m.def(
      "descriptors", [] { return list_entries(retrieval::descriptors().entries()); },
      R"(The shape descriptors: a list of dicts with name, help and parameters.

    >>> 'gsmd' in [d['name'] for d in rectilin.descriptors()]
    True)");
}

}  // namespace rectilin::python

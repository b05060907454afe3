// The house render in Python: render(), silhouette_area(), views().
#pragma once

#include <pybind11/pybind11.h>

namespace rectilin::python {

void bind_render(pybind11::module_& m);

}  // namespace rectilin::python

// The house pose in Python: pose(), poses(), normalized(), resolve_axes().
#pragma once

#include <pybind11/pybind11.h>

namespace rectilin::python {

void bind_pose(pybind11::module_& m);

}  // namespace rectilin::python

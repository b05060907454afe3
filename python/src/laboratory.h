// The laboratory in Python: compare().
#pragma once

#include <pybind11/pybind11.h>

namespace rectilin::python {

void bind_laboratory(pybind11::module_& m);

}  // namespace rectilin::python

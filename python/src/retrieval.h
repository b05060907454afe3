// The house retrieval in Python: describe(), distance(), descriptors(). To come: search().
#pragma once

#include <pybind11/pybind11.h>

namespace rectilin::python {

void bind_retrieval(pybind11::module_& m);

}  // namespace rectilin::python

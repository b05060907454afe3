// The house search in Python: rectilin.index(), Database, search(), duplicates().
#pragma once

#include <pybind11/pybind11.h>

namespace rectilin::python {

void bind_search(pybind11::module_& m);

}  // namespace rectilin::python

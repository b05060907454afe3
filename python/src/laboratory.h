// The laboratory in Python: compare(), and benchmark suites.
#pragma once

#include "optim.h"
#include "rectilin/laboratory/comparison.h"

namespace rectilin::python {

/// A problem in memory as a comparison takes it; its digest is that of the area vectors.
laboratory::ComparedMesh compared(const Problem& problem);

void bind_laboratory(py::module_& m);
void bind_suite(py::module_& m);

}  // namespace rectilin::python
